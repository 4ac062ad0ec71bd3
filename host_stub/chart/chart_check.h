#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <optional>

namespace burin::command {

/// How far the least distances that nodes tell are from those to the curve, in shares of the radius.
struct DistanceCheck {
  bool sphere = false;                ///< the surface around the stroke; or a plane
  std::size_t off_2 = 0, off_10 = 0;  ///< more than so many percent
  double mean = 0, worst = 0;
};

/// How a chart does against what is certain of its surface.
struct ChartCheck {
  std::size_t under_pen = 0;  ///< vertices within the stroke even along the edges of the mesh
  std::size_t holes = 0;      ///< of these, without a node

  /// Of the vertices under the pen with a node, where the surface around the stroke is a plane or a sphere.
  std::optional<DistanceCheck> distances;
};

/// Checks the chart of this curve. `radius`: half width of the stroke at width 1, object units.
ChartCheck check_chart(const Surface& surface, const SurfaceCurve& curve, const Chart& chart, double radius);

}  // namespace burin::command
