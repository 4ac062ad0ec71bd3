#pragma once
#include <burin/stroke/pen.h>
#include <burin/stroke/stroke_choices.h>
#include <burin/surface/surface_point.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// The time constant of CurvePoint::speed, seconds.
inline constexpr double speed_fading_time = 0.04;

/// A point of a stroke's curve on the surface with its Darboux frame: e1 = tangent, n = normal, e2 = n x e1.
struct CurvePoint {
  SurfacePoint at;
  Vec3f normal;     ///< of the surface, interpolated, unit
  Vec3f tangent;    ///< unit, perpendicular to the normal, in the direction of travel
  double t = 0;     ///< arc length from the first point, object units
  double time = 0;  ///< seconds since the first sample
  Pen pen;
  /// Object units per second: the mean over the time so far, weighted by exp(-age / speed_fading_time).
  /// Before the first sample an open curve counts as resting; a closed curve continues from its end. So the
  /// speed hardly depends on the sampling rate, and on an open curve not on later samples.
  double speed = 0;
  float width = 1;  ///< width of the stroke as a share of its radius, in (0, 1]; linear between points
};

/// A stroke on a surface: a polyline whose points lie on the surface, about half an edge apart. A closed
/// curve has one more segment, from its last point to the first.
struct SurfaceCurve {
  std::vector<CurvePoint> points;
  bool closed = false;
  double closing_length = 0;  ///< arc length from the last point to the first of a closed curve

  double length() const { return points.empty() ? 0 : points.back().t + closing_length; }  ///< object units

  /// The number of segments; segment i starts at point i. A curve of one point has one segment of length 0.
  std::size_t segment_count() const {
    return closed ? points.size() : std::max<std::size_t>(points.size(), 2) - 1;
  }
  /// The end point of the segment that starts at this point.
  std::size_t next(std::size_t point) const {
    return point + 1 < points.size() ? point + 1 : closed ? 0 : points.size() - 1;
  }
  /// The arc length at the end of a segment.
  double segment_end(std::size_t segment) const {
    return segment + 1 < points.size() ? points[segment + 1].t : length();
  }
};

}  // namespace burin
