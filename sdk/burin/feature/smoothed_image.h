#pragma once
#include <burin/feature/chart_grid.h>
#include <burin/feature/chart_samples.h>

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

/// Adds `amount` to the four pixels around a place, by bilinear weights. Nothing is added outside of the
/// image.
void splat(const ChartGrid& grid, std::span<float> image, const Vec2f& place, float amount);

/// Convolves an image with a Gaussian whose weights sum to 1; beyond its rim the image is 0.
void blur(const ChartGrid& grid, std::vector<float>& image, const Smoothing& smoothing);

}  // namespace burin
