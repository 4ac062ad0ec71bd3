#pragma once
#include <burin/level_set/grid/grids.h>
#include <burin/level_set/surface_distance.h>
#include <burin/volume/solid.h>

#include <span>

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
  Grid::Ptr base;         ///< distance to the surface, object units
  Grid::Ptr solid;        ///< to the solid
  Grid::Ptr result;       ///< negative inside the result; where its surface is near, a distance
  double contact = 0;     ///< farthest from the solid that the result leaves the surface, object units
  std::size_t bytes = 0;  ///< that the grids took together
};

Combined combine(const Operands& operands);

/// Fills balls of this radius, object units, around places where the union is too thin for the voxels: gaps
/// of a union, and of what is cut out or shared the walls between.
void fill_balls(Combined& combined, SolidOperation operation, std::span<const Vec3d> middles, double radius);

}  // namespace burin
