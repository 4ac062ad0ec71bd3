#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/joins/bends.h>
#include <burin/stroke/stroke_choices.h>

namespace burin {

/// A corner: a bend so short that its two legs, continued straight, meet at it. Arc lengths are in object
/// units.
struct Corner {
  double first, second;  ///< arc length of the meeting point on the first and on the second leg, continued
  double middle;         ///< arc length of the corner on the stroke
  double turn;           ///< radians, left positive
  double span;           ///< how far before and after the corner `smooth` spreads t
};

/// Half the absolute value of a turn, radians, at most 1.2: the tangent of larger angles grows without
/// bounds.
double bounded_half(double turn);

/// How far a mitered corner reaches beyond the meeting point along a leg, for a stroke of this radius, object
/// units; 0 for corners of 120 degrees or more, which have no miter.
double miter_reach(double turn, double radius);

/// How far along a leg, beyond the meeting point, the circle around a smooth corner reaches up to the
/// bisector, object units; 0 for corners that are nearly half turns, whose circle the bend itself gives.
double smooth_reach(double turn, double radius);

/// Whether a node of the first (or second) leg lies on its own leg's side of the corner's bisector, judged in
/// the plane from the leg's own coordinates.
bool on_own_side(const Corner& corner, bool first_leg, const ChartFrame& frame);

/// Computes t, d and e1 of a smooth join at a corner from the frame that a node has on its straight leg.
/// `normal` is the unit normal at the vertex.
ChartFrame smoothed(const Corner& corner, bool first_leg, const ChartFrame& frame, const Vec3f& normal);

/// Computes t of a smooth join in a bend that is too long to be a corner, from (t, d) of the round join.
/// `span` is how far before and after the bend's middle t is spread, object units.
double smoothed_t(const StrokeBends& bends, const Bend& bend, double span, double t, double d);

}  // namespace burin
