// Makes grids of OpenVDB from the voxels of solids. Distances in space come by sweeping outward from the
// surface [H. Zhao, A Fast Sweeping Method for Eikonal Equations, 2004].
#include <burin/level_set/grid/grids.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <cmath>
#include <memory>

namespace burin {
namespace {

using Leaf = Grid::TreeType::LeafNodeType;
static_assert(Leaf::DIM == VoxelBlock::side);

}  // namespace

Grid::Ptr empty_grid(double voxel, double half_width) {
  static const bool once = (openvdb::initialize(), true);
  static_cast<void>(once);
  const auto grid = Grid::create(static_cast<float>(half_width * voxel));
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

Grid::Ptr grid_of(const StrokeSolid& solid) {
  const Grid::Ptr grid = empty_grid(solid.voxel(), VoxelBlock::half_width);
  const float band = grid->background();
  for (const VoxelBlock& block : solid.blocks()) {
    const Eigen::Vector3i& at = block.origin;
    auto leaf = std::make_unique<Leaf>(openvdb::Coord(at.x(), at.y(), at.z()), band);
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) {
      const float value = block.values[i];
      if (std::abs(value) < band)
        leaf->setValueOn(i, value);
      else
        leaf->setValueOff(i, value);
    }
    grid->tree().addLeaf(leaf.release());
  }
  return grid;
}

Grid::Ptr distances_of(const StrokeSolid& solid) {
  Grid::Ptr grid = grid_of(solid);
  if (solid.empty()) return grid;
  grid = openvdb::tools::sdfToSdf(*grid);
  openvdb::tools::signedFloodFill(grid->tree());
  return grid;
}

}  // namespace burin
