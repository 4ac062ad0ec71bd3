#pragma once
#include <burin/level_set/grid/grids.h>

namespace burin {

/// Walls whose outward normals have a smaller scalar product than this meet at so acute an angle (60 degrees)
/// that the gap between them is filled even where no fillet is asked for.
inline constexpr double acute_walls = -0.5;

/// Fills the groove between two solids with what a ball of this radius, object units, that rolls along both
/// cannot reach; the radius may be 0, and between acute walls grows to a voxel. `both`: their union, of which
/// values within the fillet become less. The three have the same leaves; values of each solid are distances,
/// at least as far as two radii, and two voxels, from it.
void add_fillet(Grid& both, const Grid& first, const Grid& second, double radius);

}  // namespace burin
