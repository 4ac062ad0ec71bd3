#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/joins/bends.h>
#include <burin/stroke/stroke_choices.h>

namespace burin {

/// A corner: a bend so short that its two legs, continued straight, meet at it. Arc lengths are in object
/// units; on a closed stroke those of the first leg may be one length of the stroke greater than those of the
/// second.
struct Corner {
  double first, second;            ///< arc length of the meeting point on the first and on the second leg
  double first_past, second_past;  ///< how far the meeting point lies past the middle of the bend on each leg
  double turn;                     ///< radians, left positive
  double span;                     ///< how far before and after the corner `smooth` spreads t
};

/// How far along the legs from a corner, in radii, their nodes meet those of the other leg.
inline constexpr double corner_nearness = 4;

/// Half the absolute value of a turn, radians, at most 1.2: the tangent of larger angles grows without
/// bounds.
double bounded_half(double turn);

/// How far a mitered corner reaches beyond the meeting point along a leg, for a stroke of this radius, object
/// units; 0 for corners of 120 degrees or more, which have no miter.
double miter_reach(double turn, double radius);

/// How far along a leg, beyond the meeting point, the circle around a smooth corner reaches up to the
/// bisector, object units; 0 for corners that are nearly half turns, whose circle the bend itself gives.
double smooth_reach(double turn, double radius);

/// The signed distance from the corner to a node's foot along the node's leg, object units: negative on the
/// leg, positive beyond.
inline double way_beyond(const Corner& corner, bool first_leg, double t) {
  return first_leg ? t - corner.first : corner.second - t;
}

/// Whether a node of the first (or second) leg lies on its own leg's side of the corner's bisector, judged in
/// the plane from the leg's own coordinates.
bool on_own_side(const Corner& corner, bool first_leg, const ChartFrame& frame);

/// Computes t, d, e1 and the stretch of a smooth join at a corner from the frame that a node has on its
/// straight leg. `normal` is the unit normal at the vertex.
ChartFrame smoothed(const Corner& corner, bool first_leg, const ChartFrame& frame, const Vec3f& normal);

/// Computes t and the stretch of a smooth join in a bend that is not cut, from the frame of the round join.
/// `span` is how far before and after the bend's middle t is spread, object units.
ChartFrame smoothed(const StrokeBends& bends, const Bend& bend, double span, const ChartFrame& frame);

}  // namespace burin
