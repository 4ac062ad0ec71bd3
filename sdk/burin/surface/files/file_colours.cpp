// Collects the colours of vertices until all are known, since only all together tell whether channels range
// to 1 or to 255. Costs O(n).
#include <burin/surface/files/colour_byte.h>
#include <burin/surface/files/file_colours.h>

#include <algorithm>

namespace burin {

void FileColours::add(std::size_t vertex, const Colour& colour) {
  colours_.resize(vertex);
  colours_.emplace_back(colour);
}

void FileColours::give(VertexPaint& paint, std::size_t vertices, std::optional<double> full,
                       UnusedCount& unused) {
  if (colours_.empty()) return;
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(colours_, [&](const auto& colour) {
      return colour && std::any_of(colour->begin(), colour->begin() + 3, is);
    });
  };
  const double greatest =
      full.value_or(any([](double channel) { return channel > 1 + colour_rounding; }) ? 255 : 1);
  if (any([&](double channel) {
        return !(channel >= -colour_rounding && channel <= greatest + colour_rounding);
      }))
    return unused.add("colour out of range", "colours out of range", colours_.size());
  paint.colours.assign(vertices, {0, 0, 0, 0});
  for (std::size_t i = 0; i < colours_.size(); ++i)
    for (std::size_t channel = 0; channel < 4 && colours_[i]; ++channel)
      paint.colours[i][channel] = colour_byte((*colours_[i])[channel] / greatest);
}

}  // namespace burin
