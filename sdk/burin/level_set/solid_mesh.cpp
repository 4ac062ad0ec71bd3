// Surfaces come of OpenVDB's dual contouring, whose vertices are brought to where the distance is 0, taken as
// quadratic between voxels, and relaxed along the surface.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/parallel.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/level_set/solid_mesh.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin {
namespace {

using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
static_assert(Leaf::DIM == VoxelBlock::side);

openvdb::FloatGrid::Ptr empty_grid(double voxel) {
  static const bool once = (openvdb::initialize(), true);
  static_cast<void>(once);
  const auto grid = openvdb::FloatGrid::create(static_cast<float>(VoxelBlock::half_width * voxel));
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

/// The voxels of the solid's band, and the sign of the others.
openvdb::FloatGrid::Ptr grid_of(const StrokeSolid& solid) {
  const openvdb::FloatGrid::Ptr grid = empty_grid(solid.voxel());
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

/// With the same surface, and values that are distances in space, by sweeping outward from it [H. Zhao, A
/// Fast Sweeping Method for Eikonal Equations, 2004].
openvdb::FloatGrid::Ptr redistanced(const StrokeSolid& solid) {
  openvdb::FloatGrid::Ptr grid = grid_of(solid);
  if (!solid.empty()) {
    grid = openvdb::tools::sdfToSdf(*grid);
    openvdb::tools::signedFloodFill(grid->tree());
  }
  grid->setName("solid");
  return grid;
}

Vec3f vec(const openvdb::Vec3s& v) { return {v.x(), v.y(), v.z()}; }

/// The least angle's cosine of a triangle, the greater the worse.
float worst_cosine(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const auto at = [](const Vec3f& p, const Vec3f& q, const Vec3f& r) {
    return (q - p).normalized().dot((r - p).normalized());
  };
  return std::max({at(a, b, c), at(b, c, a), at(c, a, b)});
}

/// Cut along the diagonal that leaves the greater least angle.
void add_quad(TriangleMesh& mesh, const std::array<Index, 4>& quad) {
  const auto [a, b, c, d] = quad;
  const auto worst = [&](Index i, Index j, Index k) {
    return worst_cosine(mesh.positions[i], mesh.positions[j], mesh.positions[k]);
  };
  if (std::max(worst(a, b, c), worst(a, c, d)) <= std::max(worst(a, b, d), worst(b, c, d))) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  } else {
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({b, c, d});
  }
}

/// Brings points that are near the surface to it, along the gradient.
class Surfacing {
 public:
  explicit Surfacing(const openvdb::FloatGrid& grid) : grid_(&grid), voxel_(grid.voxelSize().x()) {}

  void operator()(std::vector<Vec3f>& positions) const {
    parallel_blocks(positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
      const auto accessor = grid_->getConstAccessor();
      for (std::size_t i = begin; i < end; ++i) positions[i] = on_surface(accessor, positions[i]);
    });
  }

 private:
  using Accessor = openvdb::FloatGrid::ConstAccessor;

  Vec3f on_surface(const Accessor& accessor, const Vec3f& near) const {
    constexpr int steps = 2;
    constexpr double longest = 0.5;  // voxels
    Vec3d p = near.cast<double>() / voxel_;
    for (int step = 0; step < steps; ++step) {
      const Vec3d slope = gradient(accessor, p);
      const double squared = slope.squaredNorm();
      // Where two sides meet there is no way to the surface.
      if (!(squared > 1e-2 * voxel_ * voxel_)) break;
      const double value =
          openvdb::tools::QuadraticSampler::sample(accessor, openvdb::Vec3d(p.x(), p.y(), p.z()));
      const Vec3d way = -value / squared * slope;
      const double length = way.norm();
      p += length > longest ? Vec3d(longest / length * way) : way;
    }
    return (voxel_ * p).cast<float>();
  }

  static Vec3d gradient(const Accessor& accessor, const Vec3d& p) {
    constexpr double h = 0.5;
    Vec3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d way = h * Vec3d::Unit(axis), ahead = p + way, behind = p - way;
      const auto at = [&](const Vec3d& q) {
        return static_cast<double>(
            openvdb::tools::BoxSampler::sample(accessor, openvdb::Vec3d(q.x(), q.y(), q.z())));
      };
      slope[axis] = (at(ahead) - at(behind)) / (2 * h);
    }
    return slope;
  }

  const openvdb::FloatGrid* grid_;
  double voxel_;
};

}  // namespace

TriangleMesh mesh_of(const StrokeSolid& solid) {
  const openvdb::FloatGrid::Ptr grid = grid_of(solid);
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*grid, points, triangles, quads);
  const Surfacing bring(*grid);
  TriangleMesh mesh;
  for (const openvdb::Vec3s& point : points) mesh.positions.push_back(vec(point));
  bring(mesh.positions);
  // OpenVDB counts clockwise.
  for (const auto& t : triangles) mesh.triangles.push_back({t[0], t[2], t[1]});
  for (const auto& q : quads) add_quad(mesh, {q[0], q[3], q[2], q[1]});
  relax(mesh, bring);
  return mesh;
}

void write_vdb(const std::filesystem::path& path, std::span<const StrokeSolid> solids) {
  openvdb::GridPtrVec grids;
  for (const StrokeSolid& solid : solids) grids.push_back(redistanced(solid));
  replace_file(path, [&](const std::filesystem::path& partial) {
    try {
      openvdb::io::File file(partial.string());
      file.write(grids);
      file.close();
    } catch (const openvdb::Exception& error) {
      throw FileError(path.string(), error.what());
    }
  });
}

}  // namespace burin
