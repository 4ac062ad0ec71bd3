#include <burin/base/parallel.h>
#include <burin/level_set/mesh_solid.h>
#include <burin/level_set/solid_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/error_of.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;

TriangleMesh ball(double radius, const Vec3d& middle) {
  TriangleMesh mesh = test::sphere(5, 0.1, 3);
  for (Vec3f& p : mesh.positions) p = (radius * p.cast<double>() + middle).cast<float>();
  return mesh;
}

TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<Index>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return a;
}

TEST(MeshSolid, HoldsDistancesInsideAndOutside) {
  const double voxel = 0.02, band = 3 * voxel;
  const Vec3d middle(0.1, -0.2, 0.3);
  const StrokeSolid solid = solid_of(ball(0.6, middle), voxel);
  double inside = 0, near = 0, far = 0;
  for (const VoxelBlock& block : solid.blocks()) {
    for (int i = 0; i < VoxelBlock::voxels; ++i) {
      const Vec3d p = voxel * (block.origin + Eigen::Vector3i(i / 64, i / 8 % 8, i % 8)).cast<double>();
      const double distance = std::clamp((p - middle).norm() - 0.6, -band, band);
      const double off = std::abs(static_cast<double>(block.values[static_cast<std::size_t>(i)]) - distance);
      (std::abs(distance) < voxel ? near : far) = std::max(std::abs(distance) < voxel ? near : far, off);
      if (block.values[static_cast<std::size_t>(i)] < 0) inside += std::pow(voxel, 3);
    }
  }
  // Two voxels away OpenVDB asks not all triangles.
  EXPECT_LT(near, 0.02 * voxel);
  EXPECT_LT(far, 0.3 * voxel);
  EXPECT_NEAR(inside, 4 * pi / 3 * std::pow(0.6, 3), 0.01);
}

TEST(MeshSolid, BecomesAMeshAgain) {
  const TriangleMesh mesh = mesh_of(solid_of(ball(0.6, Vec3d::Zero()), 0.03));
  const test::Edges edges = test::edges_of(mesh);
  EXPECT_EQ(edges.open, 0u);
  EXPECT_EQ(edges.euler, 2);
  const double volume = 4 * pi / 3 * std::pow(0.6, 3);
  EXPECT_NEAR(test::extent_of(mesh).volume, volume, 0.003 * volume);
}

// The volume of the lens that two balls at a distance of their radius share is 5 pi / 12 r^3.
TEST(MeshSolid, UnitesWhatOverlaps) {
  const double r = 0.4;
  const TriangleMesh mesh =
      mesh_of(solid_of(both(ball(r, Vec3d::Zero()), ball(r, Vec3d(0.4001, 0.0003, 0.0002))), 0.02));
  EXPECT_EQ(test::edges_of(mesh).euler, 2);
  const double volume = (8 * pi / 3 - 5 * pi / 12) * r * r * r;
  EXPECT_NEAR(test::extent_of(mesh).volume, volume, 0.005 * volume);
}

TEST(MeshSolid, RefusesWhatIsNone) {
  TriangleMesh mesh = ball(0.6, Vec3d::Zero());
  EXPECT_EQ(test::error_of([&] { solid_of(mesh, 0); }), "the voxel must be above 0");
  EXPECT_NE(test::error_of([&] { solid_of(mesh, 1e-5); }).find("use larger voxels"), std::string::npos);
  // 3 values for each voxel of the band of 6 voxels, and one for each within, of 4 bytes.
  EXPECT_EQ(test::error_of([&] { solid_of(mesh, 0.01, 2'000'000); }),
            "the solid's grid would take 7 MB or more, which is above the bound of 2 MB: use larger voxels");
  mesh.triangles.pop_back();
  EXPECT_EQ(test::error_of([&] { solid_of(mesh, 0.05); }),
            "the mesh is open: only a closed one bounds a solid");
}

TEST(MeshSolid, HasTheSameBitsOnOneThread) {
  const TriangleMesh mesh = both(ball(0.4, Vec3d::Zero()), ball(0.4, Vec3d(0.3, 0.1, 0)));
  const StrokeSolid all = solid_of(mesh, 0.01);
  const ThreadLimit one(1);
  const StrokeSolid alone = solid_of(mesh, 0.01);
  ASSERT_EQ(all.blocks().size(), alone.blocks().size());
  for (std::size_t i = 0; i < all.blocks().size(); ++i) {
    EXPECT_EQ(all.blocks()[i].origin, alone.blocks()[i].origin);
    EXPECT_EQ(all.blocks()[i].values, alone.blocks()[i].values);
  }
}

}  // namespace
}  // namespace burin
