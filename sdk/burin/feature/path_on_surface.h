#pragma once
#include <burin/chart/chart.h>
#include <burin/chart/chart_lookup.h>
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

/// Takes places of a path's image back to the surface. Surface, sampled feature and chart must outlive the
/// object.
class PathLookup {
 public:
  /// Looks up places near this path only. `edge`: typical length of edges, object units.
  PathLookup(const Surface& surface, const Chart& chart, const SampledFeature& sampled, const FinePath& path,
             double edge);
  PathLookup(const PathLookup&) = delete;  // The lookup refers to the part.
  PathLookup& operator=(const PathLookup&) = delete;

  /// The point of the surface that belongs to an arc length and a row, if there is one.
  std::optional<SurfacePoint> at(double t, double row) const;

 private:
  const SampledFeature& sampled_;
  Chart part_;
  ChartLookup lookup_;
};

}  // namespace burin
