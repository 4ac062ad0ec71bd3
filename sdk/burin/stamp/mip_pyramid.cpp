#include <burin/base/error.h>
#include <burin/stamp/bilinear.h>
#include <burin/stamp/mip_pyramid.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// Calls add(i, share) for the texels of a row of `from` that lie in texel `index` of a row of `to` <=
/// `from`, each with its share of that texel.
template <class Add>
void for_each_covered(std::int64_t index, std::int64_t from, std::int64_t to, const Add& add) {
  // In units of 1 / (from * to) of the row a texel of the one is `to` wide and of the other `from`.
  const std::int64_t begin = index * from, end = begin + from;
  for (std::int64_t i = begin / to; i * to < end; ++i) {
    const std::int64_t covered = std::min((i + 1) * to, end) - std::max(i * to, begin);
    add(i, static_cast<double>(covered) / static_cast<double>(from));
  }
}

double area_mean(const StampImage& fine, const StampImage& coarse, int x, int y, int channel) {
  double sum = 0;
  for_each_covered(y, fine.height, coarse.height, [&](std::int64_t row, double row_share) {
    for_each_covered(x, fine.width, coarse.width, [&](std::int64_t column, double share) {
      const std::int64_t texel = (row * fine.width + column) * fine.channels + channel;
      sum += row_share * share * double{fine.texels[static_cast<std::size_t>(texel)]};
    });
  });
  return sum;
}

StampImage halved(const StampImage& fine) {
  StampImage coarse{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), fine.channels, {}, 0, 0};
  coarse.texels.reserve(fine.texels.size() / 3);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x)
      for (int channel = 0; channel < fine.channels; ++channel)
        coarse.texels.push_back(static_cast<float>(area_mean(fine, coarse, x, y, channel)));
  set_range(coarse);
  return coarse;
}

/// The finer of two levels and the share of the coarser.
struct LevelSpan {
  std::size_t level;
  float weight;
};

/// Between powers of two in proportion to the footprint, not to its logarithm: the same bits on any machine.
LevelSpan level_span(float footprint, std::size_t levels) {
  if (!(footprint > 1)) return {0, 0};
  const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(footprint) >> 23) - 127;
  const auto level = static_cast<std::size_t>(exponent);
  if (level + 1 >= levels) return {levels - 1, 0};
  return {level, footprint / static_cast<float>(std::uint32_t{1} << level) - 1};
}

float trilinear(const MipPyramid& pyramid, int channel, float u, float v, float footprint) {
  if (!std::isfinite(u) || !std::isfinite(v) || std::isnan(footprint))
    return std::numeric_limits<float>::quiet_NaN();
  const double x = in_period(u), y = in_period(v);
  const auto [level, weight] = level_span(footprint, pyramid.levels.size());
  const float fine = bilinear(pyramid.levels[level], channel, x, y);
  if (weight == 0) return fine;
  return fine * (1 - weight) + bilinear(pyramid.levels[level + 1], channel, x, y) * weight;
}

}  // namespace

MipPyramid make_mip_pyramid(StampImage stamp) {
  MipPyramid pyramid;
  pyramid.levels.push_back(std::move(stamp));
  while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
    pyramid.levels.push_back(halved(pyramid.levels.back()));
  return pyramid;
}

void sample_mip(const MipPyramid& pyramid, int channel, const MipPlaces& places, std::span<float> values) {
  if (places.u.size() != values.size() || places.v.size() != values.size() ||
      places.footprint.size() != values.size())
    throw ContractError("sample_mip: arrays of different lengths");
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = trilinear(pyramid, channel, places.u[i], places.v[i], places.footprint[i]);
}

}  // namespace burin
