#pragma once
#include <burin/volume/solid.h>
#include <openvdb/openvdb.h>

namespace burin {

using Grid = openvdb::FloatGrid;

/// A level set without voxels, in object units, outside everywhere; `half_width` in voxels.
Grid::Ptr empty_grid(double voxel, double half_width);

/// The voxels of a solid's band as the brush has them, and the sign of the others.
Grid::Ptr grid_of(const StrokeSolid& solid);

/// Of the same surface, with values that are distances in space.
Grid::Ptr distances_of(const StrokeSolid& solid);

}  // namespace burin
