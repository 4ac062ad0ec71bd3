#pragma once
#include <burin/stroke/curve.h>
#include <burin/stroke/dynamics.h>

#include <cstddef>

namespace burin {

/// One segment of the spline that curves follow between their knots, in Hermite form over [0, 1].
struct HermiteSegment {
  Vec3d from, to, tangent_from, tangent_to;

  Vec3d position(double s) const;
  Vec3d velocity(double s) const;
};

/// The interval of the spline's parameter from one knot to the next.
enum class KnotSpacing {
  centripetal,  ///< the root of the chord: no loops between knots that are far apart
  chordal,      ///< the chord: tangents exact to second order between knots that are near each other
};

/// The segment from b to c of the Catmull-Rom spline through a, b, c and d; a or d may be missing.
HermiteSegment spline_segment(const Vec3d* a, const Vec3d& b, const Vec3d& c, const Vec3d* d,
                              KnotSpacing spacing);

/// The length of the circular arc over the chord from a point to `to` that turns from one tangent to the
/// other, to second order in the turn. At a corner, the length of the chord.
double arc_length(const CurvePoint& from, const Vec3f& to, const Vec3f& tangent);

/// Sets CurvePoint::width of the points from this one on.
void set_widths(SurfaceCurve& curve, const StrokeWidth& width, std::size_t from_point);

}  // namespace burin
