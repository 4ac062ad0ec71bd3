#pragma once
#include <burin/stroke/pen.h>

namespace burin {

// These functions represent the tilt of a pen as a direction, so that interpolation takes the shorter way
// round and a pen that lies flat is no special case.

/// The unit vector from the pen's tip to its upper end: x and y in the plane of the tilts, z away from it.
/// Tilts beyond 90 degrees count as 90.
Vec3d upper_end(const Pen& pen);

/// Sets the tilts to those of this direction, which need not be unit; a zero direction means upright. The
/// direction is raised to at least 0.05 degrees above the plane, since two tilts of 90 degrees would lose the
/// direction of a flat pen.
void set_upper_end(Pen& pen, const Vec3d& direction);

/// Whether both tilts are equal, bit for bit except for the sign of zero.
bool same_tilt(const Pen& a, const Pen& b);

/// The twist plus or minus whole turns so that it is at most half a turn from `near`, radians.
double twist_near(double twist, double near);

/// The twist in [0, 2 pi); one in that range is unchanged.
float wrap_twist(double twist);

/// Interpolates between two pens; `share`: 0 for a, 1 for b.
Pen pen_between(const Pen& a, const Pen& b, float share);

}  // namespace burin
