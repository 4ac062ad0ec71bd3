#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

// The strongest of several changes, as a continuous function of the changes. Changes in one direction give
// the greatest of them, changes in opposite directions the sum of the greatest of each direction. A zero
// change does not influence the result, so a change that fades to zero at a rim causes no step there. The
// order of changes does not matter.

/// The sum of the highest rise and the deepest cut; 0 without changes.
double strongest(std::span<const double> changes);

/// The strongest of several vectors. The component along the unit vector `normal` is that of the scalar
/// function. The component at right angles to it is twice the Steiner point of the convex hull of all changes
/// and zero: the same rule in two dimensions, invariant to reflections and rotations. The result is not
/// longer than the longest change.
Vec3d strongest(std::span<const Vec3d> changes, const Vec3d& normal);

}  // namespace burin
