#pragma once
#include <burin/level_set/grid/grids.h>
#include <burin/level_set/surface_distance.h>
#include <burin/volume/solid.h>

namespace burin {

/// What is combined.
struct Operands {
  const StrokeSolid& voxels;
  const SurfaceDistance& solid;  ///< to the same solid
  const SurfaceDistance& base;   ///< to the surface
  SolidOperation operation;
  double
      blend;  ///< radius of a ball that leaves a fillet where it rolls along both; object units, 0 for none
  const Progress& progress;
};

/// A surface and a solid in the voxels around the solid, and what they become together.
struct Combined {
  Grid::Ptr solid;        ///< distance to the solid, object units
  Grid::Ptr result;       ///< negative inside the result; where its surface is near, a distance
  double contact = 0;     ///< farthest from the solid that the result leaves the surface, object units
  std::size_t bytes = 0;  ///< that the grids took together
};

Combined combine(const Operands& operands);

}  // namespace burin
