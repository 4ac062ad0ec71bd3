#pragma once
#include <burin/stroke/pen.h>

namespace burin {

// The angles of a pen as directions, so that what lies between two of them goes the shorter way round and a
// pen that lies flat is no exception.

/// From the pen's tip to its upper end, unit: x and y in the plane of the tilts, z away from it. Tilts beyond
/// 90 degrees count as 90.
Vec3d upper_end(const Pen& pen);

/// The tilts of this direction, which need not be unit; upright for zero. Held at least 0.05 degrees above
/// the plane, since two tilts of 90 degrees would not tell where a flat pen points to.
void set_upper_end(Pen& pen, const Vec3d& direction);

bool same_tilt(const Pen& a, const Pen& b);

/// The twist less whole turns such that it is at most half a turn from `near`, radians.
double twist_near(double twist, double near);

/// The same twist in [0, 2 pi), or as it is where it lies there already.
float within_turn(double twist);

/// At a share of the way from one pen to the other, 0..1.
Pen pen_between(const Pen& a, const Pen& b, float share);

}  // namespace burin
