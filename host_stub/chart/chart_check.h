#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <optional>

namespace burin::command {

/// The errors of the distances of a chart's vertices from the curve.
struct DistanceCheck {
  bool sphere = false;                ///< the surface around the stroke is a sphere; otherwise a plane
  std::size_t off_2 = 0, off_10 = 0;  ///< number of errors above 2 and above 10 percent of the radius
  double mean = 0, worst = 0;         ///< mean and greatest error, as shares of the radius
};

/// The result of checking a chart.
struct ChartCheck {
  std::size_t under_pen = 0;  ///< number of vertices within the stroke even along the edges of the mesh
  std::size_t holes = 0;      ///< number of these without a node

  /// The errors at the vertices under the pen that have a node, if the surface around the stroke is a plane
  /// or a sphere and the joins are round or overlap.
  std::optional<DistanceCheck> distances;
};

/// Checks the chart of this curve, which must have round ends and may lie on a base surface. The picker is
/// that of the surface. `radius` is the half width of the stroke at width 1, object units.
ChartCheck check_chart(const Surface& surface, const Picker& picker, const SurfaceCurve& curve,
                       const Chart& chart, double radius, Join join);

}  // namespace burin::command
