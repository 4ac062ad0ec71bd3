#pragma once
#include <burin/stroke/pen.h>
#include <burin/surface/surface_point.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// Seconds; see CurvePoint::speed.
inline constexpr double speed_fading_time = 0.04;

/// A point of a stroke on a surface with its Darboux frame: e1 = tangent, n = normal, e2 = n x e1.
struct CurvePoint {
  SurfacePoint at;
  Vec3f normal;     ///< of the surface, interpolated, unit
  Vec3f tangent;    ///< unit, at right angles to the normal, in the direction of travel
  double t = 0;     ///< arc length from the first point, object units
  double time = 0;  ///< seconds since the first sample
  Pen pen;
  /// Object units a second: the mean over the time so far that fades as exp(-age / speed_fading_time). Before
  /// the first sample the pen rested; that of a closed curve came around. So it hardly depends on the rate
  /// of the samples, and on an open curve not on later ones.
  double speed = 0;
  float width = 1;  ///< of the stroke here, a share of its radius, in (0, 1]; linear between points
};

/// A stroke on a surface: a polyline whose points lie on it, about half an edge apart. A closed one goes on
/// from its last point to the first.
struct SurfaceCurve {
  std::vector<CurvePoint> points;
  bool closed = false;
  double closing_length = 0;  ///< arc length from the last point to the first of a closed curve

  double length() const { return points.empty() ? 0 : points.back().t + closing_length; }

  /// Segments go from a point to the next. A curve of one point has one, without extent.
  std::size_t segment_count() const {
    return closed ? points.size() : std::max<std::size_t>(points.size(), 2) - 1;
  }
  /// The point at which the segment from this point ends.
  std::size_t next(std::size_t point) const {
    return point + 1 < points.size() ? point + 1 : closed ? 0 : points.size() - 1;
  }
  /// Arc length at the end of a segment.
  double segment_end(std::size_t segment) const {
    return segment + 1 < points.size() ? points[segment + 1].t : length();
  }
};

/// Whether a stroke goes around.
enum class Closure {
  open,
  closed,
  automatic,  ///< closed where the pen came back, as CurveTracer::came_back() says
};

}  // namespace burin
