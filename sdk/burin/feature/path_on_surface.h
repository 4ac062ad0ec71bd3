#pragma once
#include <burin/chart/chart.h>
#include <burin/feature/found_path.h>
#include <burin/feature/sampled_feature.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <optional>
#include <vector>

namespace burin {

/// A path with points at even distances along the stroke, from t = 0 on.
struct FinePath {
  std::vector<PathColumn> points;
  double step = 0;  ///< object units
};

/// A path through the columns of the stroke, from its start to its end, with points at most `spacing` apart
/// along the stroke (object units): a Catmull-Rom spline.
FinePath finer_path(const std::vector<PathColumn>& columns, const ChartGrid& grid, double spacing);

/// The points of the surface that belong to the points of a path, where there are any. `edge`: typical length
/// of edges, object units.
std::vector<std::optional<SurfacePoint>> on_surface(const Surface& surface, const Chart& chart,
                                                    const SampledFeature& sampled, const FinePath& path,
                                                    double edge);

}  // namespace burin
