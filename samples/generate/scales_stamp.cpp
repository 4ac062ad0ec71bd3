// Computes the stamp of overlapping scales.
#include <burin/math/elementary.h>

#include "scales_stamp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "exr_file.h"

namespace burin::samples {

namespace {

constexpr int size = 256;               // texels each way
constexpr int period = 64;              // texels
constexpr int scales_oversampling = 4;  // each way, since the edges of scales are steps

constexpr double scale_radius = .64;  // periods

/// The height of the scale around the origin, 0 outside of it: a plate that rises towards its free edge,
/// arched across, with a rounded rim and a low keel.
double scale_height(double u, double v) {
  const double along = u / scale_radius, across = v / scale_radius;
  const double rho = math::hypot(along, across);
  if (rho >= 1) return 0;
  const double rim = std::sqrt(1 - math::pow(rho, 8));
  const double keel = .10 * math::exp(-across * across / (.09 * .09)) * (1 - rho);
  return (.55 + .40 * along - .22 * across * across + keel) * rim;
}

/// The height of the highest scale in a lattice that has scales at (0, 0) and (1/2, 1/2) of every period.
double pattern_height(double u, double v) {
  double highest = 0;
  for (int row = -1; row <= 2; ++row)
    for (int column = -1; column <= 2; ++column) {
      highest = std::max(highest, scale_height(u - row, v - column));
      highest = std::max(highest, scale_height(u - row - .5, v - column - .5));
    }
  return highest;
}

double texel_height(int x, int y) {
  double sum = 0;
  for (int i = 0; i < scales_oversampling; ++i)
    for (int j = 0; j < scales_oversampling; ++j)
      sum += pattern_height((x + (i + .5) / scales_oversampling) / period,
                            (y + (j + .5) / scales_oversampling) / period);
  return sum / (scales_oversampling * scales_oversampling);
}

/// The heights of one period, scaled to 0..1.
std::vector<float> period_heights() {
  std::vector<float> heights;
  for (int y = 0; y < period; ++y)
    for (int x = 0; x < period; ++x) heights.push_back(static_cast<float>(texel_height(x, y)));
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const float base = *low, range = *high - *low;
  for (float& height : heights) height = (height - base) / range;
  return heights;
}

}  // namespace

void write_scales(const std::filesystem::path& path) {
  const std::vector<float> tile = period_heights();
  std::vector<float> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      texels.push_back(
          tile[static_cast<std::size_t>(y % period) * period + static_cast<std::size_t>(x % period)]);

  write_exr(path, size, size, {"Y"}, texels);
}

}  // namespace burin::samples
