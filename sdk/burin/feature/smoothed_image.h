#pragma once
#include <burin/feature/chart_grid.h>
#include <burin/feature/chart_samples.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// Values of scattered samples, smoothed by a Gaussian in the (t, d) plane. Each is the mean of the samples
/// around a pixel, weighted by their areas and by the Gaussian (normalized convolution, Knutsson and Westin
/// 1993), so that neither holes nor the density of vertices matter.
struct SmoothedImage {
  ChartGrid grid;
  std::vector<std::vector<float>> channels;  ///< [channel][pixel]; 0 where not known
  std::vector<bool> known;                   ///< [pixel] whether there are enough samples around it

  float at(std::size_t channel, int column, int row) const {
    return channels[channel][grid.pixel(column, row)];
  }
};

/// Standard deviations of a Gaussian, pixels.
struct Smoothing {
  double columns, rows;
};

/// Smooths `values`, which are `channels` numbers per sample. Costs O(samples + pixels x deviations) per
/// channel.
SmoothedImage smoothed_image(const ChartSamples& samples, std::span<const float> values, std::size_t channels,
                             const Smoothing& smoothing);

/// The pixels around a place, with their bilinear weights; those outside of the image are left out.
struct PixelShares {
  std::array<std::size_t, 4> pixels{};
  std::array<float, 4> shares{};
  std::size_t count = 0;

  /// Divides `amount` among the pixels.
  void add_to(std::span<float> image, float amount) const {
    for (std::size_t i = 0; i < count; ++i) image[pixels[i]] += amount * shares[i];
  }
};
PixelShares pixel_shares(const ChartGrid& grid, const Vec2f& place);

/// Convolves an image with a Gaussian whose weights sum to 1; beyond its rim the image is 0.
void blur(const ChartGrid& grid, std::vector<float>& image, const Smoothing& smoothing);

}  // namespace burin
