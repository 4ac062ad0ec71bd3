#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/joins/bends.h>
#include <burin/chart/stroke_shape.h>

namespace burin {

/// A corner: a bend so short that its legs, straight on, meet where it is.
struct Corner {
  double first, second;  ///< arc length that the meeting point would have on either leg
  double middle;         ///< arc length that it has on the stroke
  double turn;           ///< radians, left positive
  double span;           ///< how far before and after it `smooth` spreads t
};

/// Half of a turn, radians, without its sign. Half turns of more than 1.2 are taken for it: their tangents
/// grow beyond bounds.
double bounded_half(double turn);

/// How far a mitered corner reaches beyond the meeting point along a leg, for a stroke of this radius; 0 for
/// corners too sharp for miters.
double miter_reach(double turn, double radius);

/// Whether a node of the first (or second) leg lies on its own leg's side of the corner's bisector, judged in
/// the plane from the leg's own coordinates.
bool on_own_side(const Corner& corner, bool first_leg, const ChartFrame& frame);

/// t, d and e1 as `smooth` has them from those of a leg, around which the frame goes on straight. `normal`:
/// of the vertex.
ChartFrame smoothed(const Corner& corner, bool first_leg, const ChartFrame& frame, const Vec3f& normal);

/// t as `smooth` has it in a bend too long to be a corner, from that of the plain chart. `span` as above.
double smoothed_t(const StrokeBends& bends, const Bend& bend, double span, double t, double d);

}  // namespace burin
