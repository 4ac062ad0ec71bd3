// Normalized convolution of scattered samples: amounts and weights are splatted into images, which a
// separable Gaussian blurs; their quotient is the weighted mean.
#include <burin/feature/smoothed_image.h>
#include <burin/math/elementary.h>
#include <burin/math/median.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The right half of a Gaussian, from its middle to three deviations; the whole sums to 1.
std::vector<float> half_gaussian(double deviation) {
  const int reach = static_cast<int>(std::ceil(3 * deviation));
  std::vector<double> half;
  double sum = -1;
  for (int i = 0; i <= reach; ++i) {
    const double x = deviation > 0 ? i / deviation : 0;
    half.push_back(math::exp(-x * x / 2));
    sum += 2 * half.back();
  }
  std::vector<float> result(half.size());
  std::ranges::transform(half, result.begin(), [&](double value) { return static_cast<float>(value / sum); });
  return result;
}

/// Adds `factor` times a row of numbers to another one.
void add_scaled(float* to, const float* from, float factor, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] += factor * from[i];
}

void blur_along_t(const ChartGrid& grid, std::vector<float>& image, const std::vector<float>& half) {
  std::vector<float> result(image.size());
  const auto rows = static_cast<std::size_t>(grid.rows);
  for (int column = 0; column < grid.columns; ++column) {
    float* const to = &result[grid.pixel(column, 0)];
    for (int k = 0; k < static_cast<int>(half.size()); ++k) {
      const float factor = half[static_cast<std::size_t>(k)];
      if (column + k < grid.columns) add_scaled(to, &image[grid.pixel(column + k, 0)], factor, rows);
      if (k > 0 && column >= k) add_scaled(to, &image[grid.pixel(column - k, 0)], factor, rows);
    }
  }
  image.swap(result);
}

void blur_along_d(const ChartGrid& grid, std::vector<float>& image, const std::vector<float>& half) {
  std::vector<float> before(static_cast<std::size_t>(grid.rows));
  for (int column = 0; column < grid.columns; ++column) {
    float* const to = &image[grid.pixel(column, 0)];
    std::copy_n(to, grid.rows, before.begin());
    std::fill_n(to, grid.rows, 0.F);
    const auto reach = std::min(half.size(), before.size());
    for (std::size_t k = 0; k < reach; ++k) {
      add_scaled(to, before.data() + k, half[k], before.size() - k);
      if (k > 0) add_scaled(to + k, before.data(), half[k], before.size() - k);
    }
  }
}

/// The least weight of a pixel that counts as known, as a share of the median of those with any weight.
float least_weight(const std::vector<float>& weights) {
  constexpr float least_share = 0.15F;
  std::vector<float> some;
  std::ranges::copy_if(weights, std::back_inserter(some), [](float weight) { return weight > 0; });
  if (some.empty()) return 0;
  return least_share * math::median(some);
}

}  // namespace

PixelShares pixel_shares(const ChartGrid& grid, const Vec2f& place) {
  const float column = std::floor(place.x()), row = std::floor(place.y());
  const float across = place.x() - column, along = place.y() - row;
  PixelShares shares;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const int at_column = static_cast<int>(column) + i, at_row = static_cast<int>(row) + j;
      if (at_column < 0 || at_column >= grid.columns || at_row < 0 || at_row >= grid.rows) continue;
      shares.pixels[shares.count] = grid.pixel(at_column, at_row);
      shares.shares[shares.count++] = (i == 0 ? 1 - across : across) * (j == 0 ? 1 - along : along);
    }
  }
  return shares;
}

void blur(const ChartGrid& grid, std::vector<float>& image, const Smoothing& smoothing) {
  blur_along_t(grid, image, half_gaussian(smoothing.columns));
  blur_along_d(grid, image, half_gaussian(smoothing.rows));
}

SmoothedImage smoothed_image(const ChartSamples& samples, std::span<const float> values, std::size_t channels,
                             const Smoothing& smoothing) {
  const ChartGrid& grid = samples.grid();
  SmoothedImage result{grid, std::vector(channels, std::vector<float>(grid.size())), {}};
  std::vector<float> weights(grid.size());
  for (std::size_t i = 0; i < samples.all().size(); ++i) {
    const ChartSample& sample = samples.all()[i];
    const PixelShares shares = pixel_shares(grid, {sample.x, sample.y});
    shares.add_to(weights, sample.area);
    for (std::size_t k = 0; k < channels; ++k)
      shares.add_to(result.channels[k], sample.area * values[i * channels + k]);
  }
  blur(grid, weights, smoothing);
  for (std::vector<float>& channel : result.channels) blur(grid, channel, smoothing);
  const float least = least_weight(weights);
  result.known.resize(grid.size());
  for (std::size_t pixel = 0; pixel < grid.size(); ++pixel) {
    result.known[pixel] = weights[pixel] > 0 && weights[pixel] >= least;
    const float factor = result.known[pixel] ? 1 / weights[pixel] : 0;
    for (std::vector<float>& channel : result.channels) channel[pixel] *= factor;
  }
  return result;
}

}  // namespace burin
