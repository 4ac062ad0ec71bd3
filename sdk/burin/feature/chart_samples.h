#pragma once
#include <burin/chart/chart.h>
#include <burin/feature/chart_grid.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// A node of a chart in an image.
struct ChartSample {
  float x = 0, y = 0;  ///< place in the image, pixels
  float area = 0;      ///< a third of that of the triangles around its vertex, object units^2
  Index vertex = no_index;
  Vec3f position;  ///< object units, from ChartSamples::origin()
  /// Mean of the normals of these triangles by their areas. Smoothed, it is the slope of the smoothed
  /// surface, as it would not be if vertex normals were used, whose errors do not cancel out.
  Vec3f mean_normal;
  Vec3f normal;  ///< of the vertex, unit
};

/// The nodes of a chart by columns of an image. Built in O(n) for n nodes.
class ChartSamples {
 public:
  ChartSamples(const Surface& surface, const Chart& chart, const ChartGrid& grid);

  const ChartGrid& grid() const { return grid_; }
  const Vec3f& origin() const { return origin_; }
  std::span<const ChartSample> all() const { return samples_; }
  /// Those nearer to this column than to another one, in the order of the chart.
  std::span<const ChartSample> column(int column) const {
    const auto at = static_cast<std::size_t>(column);
    return std::span(samples_).subspan(offsets_[at], offsets_[at + 1] - offsets_[at]);
  }

 private:
  ChartGrid grid_;
  Vec3f origin_ = Vec3f::Zero();
  std::vector<ChartSample> samples_;
  std::vector<Index> offsets_;  ///< [column] its first sample
};

}  // namespace burin
