// Composites colours over clay in linear RGB, and detects colours that another program has painted over.
#include <burin/base/srgb.h>
#include <burin/surface/files/over_clay.h>

#include <algorithm>
#include <cstdlib>

namespace burin {
namespace {

/// The greatest change of a channel by programs that convert colours to their own format and back.
constexpr int rounding = 1;

bool are_alike(const PaintBytes& a, const PaintBytes& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](int channel, int other) { return std::abs(channel - other) <= rounding; });
}

}  // namespace

Vec3f over_clay(const PaintBytes& colour) {
  const Vec3f ink(from_srgb(colour[0]), from_srgb(colour[1]), from_srgb(colour[2]));
  const float coverage = static_cast<float>(colour[3]) / 255;
  return coverage * ink + (1 - coverage) * clay_colour;
}

PaintBytes bytes_over_clay(const PaintBytes& colour) {
  if (colour[3] == 255) return colour;
  const Vec3f shown = over_clay(colour);
  return {to_srgb(shown.x()), to_srgb(shown.y()), to_srgb(shown.z()), 255};
}

bool shows_clay(const std::vector<PaintBytes>& colours) {
  return std::ranges::any_of(colours, [](const PaintBytes& colour) { return colour[3] < 255; });
}

std::vector<PaintBytes> ink_unless_painted_over(const std::vector<PaintBytes>& shown,
                                                std::vector<PaintBytes> ink) {
  for (std::size_t i = 0; i < ink.size(); ++i)
    if (!are_alike(shown[i], bytes_over_clay(ink[i]))) ink[i] = shown[i];
  return ink;
}

}  // namespace burin
