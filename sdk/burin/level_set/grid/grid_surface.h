#pragma once
#include <burin/level_set/grid/grids.h>
#include <burin/surface/triangle_mesh.h>

#include <vector>

namespace burin {

/// Brings points that are near the surface of a grid to it, along the gradient; the distance counts as
/// quadratic between voxels. The grid must outlive it.
class GridSurface {
 public:
  explicit GridSurface(const Grid& grid) : grid_(&grid), voxel_(grid.voxelSize().x()) {}

  void bring(std::vector<Vec3f>& positions) const;
  Vec3d bring(const Vec3d& near) const;

  /// The surface within half a voxel: closed, counter-clockwise seen from outside, of OpenVDB's dual
  /// contouring.
  TriangleMesh mesh() const;

 private:
  using Accessor = Grid::ConstAccessor;

  Vec3d on_surface(const Accessor& accessor, const Vec3d& near) const;
  static Vec3d gradient(const Accessor& accessor, const Vec3d& p);

  const Grid* grid_;
  double voxel_;
};

}  // namespace burin
