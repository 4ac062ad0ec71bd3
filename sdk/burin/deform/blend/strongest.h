#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

// The strongest of several changes, without a step where another becomes the strongest. Changes of one
// direction give the greatest of them, opposite ones the sum of the greatest of each direction. A change of
// nothing changes nothing, so that what fades to nothing at a rim has no step there; and the order of changes
// does not matter.

/// The highest rise and the deepest cut together.
double strongest(std::span<const double> changes);

/// Along the unit `normal` as numbers are. At right angles to it twice the Steiner point of the convex hull
/// of all changes and of none, which is the same in two dimensions and follows mirrorings and turns. No
/// longer than the longest change.
Vec3d strongest(std::span<const Vec3d> changes, const Vec3d& normal);

}  // namespace burin
