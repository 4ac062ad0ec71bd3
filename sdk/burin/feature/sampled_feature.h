#pragma once
#include <burin/feature/chart_samples.h>
#include <burin/feature/edge_lines.h>
#include <burin/feature/feature.h>
#include <burin/feature/level_image.h>
#include <burin/feature/local_fit.h>
#include <burin/feature/smoothed_image.h>

#include <optional>

namespace burin {

/// The function of a feature in the image of a chart: smoothed, and sampled at the chart's nodes. Surface,
/// chart, samples and feature must outlive the object.
class SampledFeature {
 public:
  /// `smoothing`: of the image, pixels.
  SampledFeature(const Surface& surface, const Chart& chart, const ChartSamples& samples,
                 const Feature& feature, const Smoothing& smoothing);

  const LevelImage& level() const { return level_; }

  /// What paths are searched in, see best_path().
  LevelImage score() const;

  FeatureKind kind() const { return feature_.kind; }

  /// Those of a feature that consists of edges, else none.
  const std::vector<LineEdge>& edges() const { return edges_; }

  /// A row of a column.
  struct ExactRow {
    double offset = 0;    ///< from the row that it is near, pixels
    double variance = 0;  ///< pixels^2
  };
  /// The feature's exact row near a row of a column, if the nodes around it determine it. Each of `fits` fits
  /// is centred on what the one before found, so that its window gets symmetric.
  std::optional<ExactRow> refine(int column, double row, int fits) const;

  /// The point of the surface that belongs to a place (column, row) of the feature, if the feature knows it
  /// better than the chart does: that of a line of edges.
  std::optional<SurfacePoint> point_at(double column, double row) const;

 private:
  LevelImage make_level();
  std::optional<LinePoint> near_line(double column, double row) const;
  std::optional<ExactRow> fit(int column, double row) const;
  std::optional<ExactRow> radial_row(const LocalFit& fit, const FitWindow& window) const;
  std::optional<LocalFit> fit_values(const FitWindow& window) const;
  std::optional<LocalFit> fit_profile(const FitWindow& window) const;

  const Surface& surface_;
  const ChartSamples& samples_;
  const Feature& feature_;
  Smoothing smoothing_;
  SmoothedImage smoothed_;       ///< geometry or values; empty for lines of edges
  std::vector<LineEdge> edges_;  ///< of these
  LevelImage level_;
};

}  // namespace burin
