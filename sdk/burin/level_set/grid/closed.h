#pragma once
#include <burin/level_set/grid/grids.h>

namespace burin {

/// Fills what a ball of this radius, voxels, cannot reach from outside, such as the bottom of a valley
/// between two strands that touch, by more than about a tenth of a voxel; all else stays as it is.
void close(Grid& grid, double radius);

}  // namespace burin
