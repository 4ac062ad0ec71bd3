// Finds the voxels of a closed mesh by OpenVDB, which finds the distance to the nearest triangle and what is
// inside by filling the outside.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/mesh_solid.h>
#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

using FieldTree = openvdb::FloatTree;
static_assert(FieldTree::LeafNodeType::DIM == VoxelBlock::side);

/// Whether every edge is run along as often in one direction as in the other.
bool is_closed(const TriangleMesh& mesh) {
  std::vector<std::pair<Index, Index>> there, back;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = t[i], to = t[(i + 1) % 3];
      if (from == to) continue;
      there.emplace_back(from, to);
      back.emplace_back(to, from);
    }
  }
  parallel_sort(there.begin(), there.end());
  parallel_sort(back.begin(), back.end());
  return there == back;
}

/// What the voxels take at least: those of the band, with the triangles they are nearest to, and those
/// within.
double least_bytes(const TriangleMesh& mesh, double voxel) {
  double area = 0, volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
                c = mesh.positions[t[2]].cast<double>();
    area += (b - a).cross(c - a).norm() / 2;
    volume += a.dot(b.cross(c)) / 6;
  }
  constexpr double values_of_band = 3;
  const double band = 2 * VoxelBlock::half_width * voxel * area;
  return (values_of_band * band + std::abs(volume)) * sizeof(float) / (voxel * voxel * voxel);
}

void check(const TriangleMesh& mesh, double voxel, std::size_t most_bytes) {
  constexpr double mega = 1e6;
  if (!(voxel > 0 && std::isfinite(voxel))) throw Error("the voxel must be above 0");
  if (!is_closed(mesh)) throw Error("the mesh is open: only a closed one bounds a solid");
  if (const double bytes = least_bytes(mesh, voxel); !(bytes <= static_cast<double>(most_bytes)))
    throw Error(
        fmt::format("the solid's grid would take {:.0f} MB or more, which is above the bound of {:.0f} MB: "
                    "use larger voxels",
                    bytes / mega, static_cast<double>(most_bytes) / mega));
}

openvdb::FloatGrid::Ptr grid_of(const TriangleMesh& mesh, double voxel) {
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  points.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<openvdb::Vec3I> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
      *openvdb::math::Transform::createLinearTransform(voxel), points, triangles,
      static_cast<float>(VoxelBlock::half_width));
}

/// Those that hold something of the solid or its band.
std::vector<VoxelBlock> blocks_of(const FieldTree& tree, double voxel) {
  const auto band = static_cast<float>(VoxelBlock::half_width * voxel);
  std::vector<VoxelBlock> blocks;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) {
    VoxelBlock block;
    const openvdb::Coord at = leaf->origin();
    block.origin = {at.x(), at.y(), at.z()};
    for (openvdb::Index i = 0; i < FieldTree::LeafNodeType::SIZE; ++i)
      block.values[i] = std::clamp(leaf->getValue(i), -band, band);
    if (std::ranges::min(block.values) < band) blocks.push_back(block);
  }
  // What lies deep inside has one value for many voxels.
  auto tile = tree.cbeginValueAll();
  tile.setMaxDepth(FieldTree::ValueAllCIter::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    if (!(tile.getValue() < 0)) continue;
    const openvdb::CoordBBox box = tile.getBoundingBox();
    for (int x = box.min().x(); x <= box.max().x(); x += VoxelBlock::side)
      for (int y = box.min().y(); y <= box.max().y(); y += VoxelBlock::side)
        for (int z = box.min().z(); z <= box.max().z(); z += VoxelBlock::side) {
          VoxelBlock block;
          block.origin = {x, y, z};
          block.values.fill(-band);
          blocks.push_back(block);
        }
  }
  std::ranges::sort(blocks, [](const VoxelBlock& a, const VoxelBlock& b) {
    return std::ranges::lexicographical_compare(a.origin, b.origin);
  });
  return blocks;
}

}  // namespace

StrokeSolid solid_of(const TriangleMesh& mesh, double voxel, std::size_t most_bytes) {
  check(mesh, voxel, most_bytes);
  return {voxel, blocks_of(grid_of(mesh, voxel)->tree(), voxel)};
}

}  // namespace burin
