// Rods along strokes, whose volume and area are known. By Pappus they are those of a straight rod where the
// middle of the section runs along the stroke.
#include <burin/base/parallel.h>
#include <burin/level_set/solid_mesh.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>

#include "support/charted.h"
#include "support/closed_curve.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;

constexpr double stroke_radius = 0.2, rod_radius = 0.05;

/// A rod, and how far a place is from its true surface.
struct Rod {
  const char* name;
  TriangleMesh ground;
  std::vector<Vec3d> samples;
  bool closed;
  double height;
  std::function<double(const Vec3d&)> distance;
};

std::vector<Vec3d> around(const std::function<Vec3d(double)>& way) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 240; ++i) samples.push_back(way(2 * pi * i / 240));
  return samples;
}

Rod straight_on_plane() {
  const Vec3d from(-0.5, -0.1, 0), to(0.5, 0.12, 0);
  const double height = 0.02;
  return {"straight rod on a plane",
          test::plane(1, 0.02, 7),
          test::sampled(40, [=](double s) { return Vec3d(from + s * (to - from)); }),
          false,
          height,
          [=](const Vec3d& p) {
            const Vec3d way = to - from, q = p - from - Vec3d(0, 0, height);
            return (q - std::clamp(q.dot(way) / way.squaredNorm(), 0., 1.) * way).norm() - rod_radius;
          }};
}

Rod ring_on_plane() {
  return {
      "ring on a plane",
      test::plane(1, 0.02, 7),
      around([](double s) { return Vec3d(0.5 * std::cos(s), 0.5 * std::sin(s), 0); }),
      true,
      0.02,
      [](const Vec3d& p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.5, p.z() - 0.02) - rod_radius; }};
}

Rod ring_around_cylinder() {
  return {
      "ring around a cylinder",
      test::cylinder(0.5, 0.6, 0.02, 0.2, 5),
      around([](double s) { return Vec3d(0.5 * std::cos(s), 0.5 * std::sin(s), 0.02); }),
      true,
      0,
      [](const Vec3d& p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.5, p.z() - 0.02) - rod_radius; }};
}

/// d is an arc of the sphere.
Rod ring_around_sphere() {
  return {"great circle of a sphere",
          test::sphere(6, 0.2, 4),
          around([](double s) { return Vec3d(std::cos(s), std::sin(s), 0); }),
          true,
          0,
          [](const Vec3d& p) { return std::hypot(std::asin(p.z() / p.norm()), p.norm() - 1) - rod_radius; }};
}

double crate(double x, double y) { return 0.03 * std::sin(2 * pi / 1.2 * x) * std::sin(2 * pi / 1.2 * y); }

Rod on_egg_crate() {
  TriangleMesh mesh = test::plane(1, 0.02, 7);
  for (Vec3f& p : mesh.positions)
    p.z() = static_cast<float>(crate(static_cast<double>(p.x()), static_cast<double>(p.y())));
  return {"ring on an egg crate",
          mesh,
          around([](double s) {
            const double x = 0.5 * std::cos(s), y = 0.5 * std::sin(s);
            return Vec3d(x, y, crate(x, y));
          }),
          true,
          0,
          {}};
}

struct Made {
  TriangleMesh mesh;
  double length;
};

Made make(const Rod& rod, double voxel) {
  test::Charted charted(rod.ground);
  Chart chart;
  const ChartOptions options{.radius = stroke_radius};
  charted.builder.begin(options);
  charted.curve = test::traced(CurveGround(charted.surface, charted.picker, charted.builder.base()),
                               charted.picker, stroke_radius, rod.samples);
  if (rod.closed) test::close(charted.curve);
  chart = charted.builder.draw(charted.curve).sorted();
  const SolidGround ground{charted.surface, chart, [&](Index v) { return charted.surface.positions[v]; }};
  const SolidExtent extent{.h_min = rod.height - rod_radius,
                           .h_max = rod.height + rod_radius,
                           .radius = stroke_radius,
                           .voxel = voxel};
  return {mesh_of(StrokeSolid(ground, extent, test::rod(chart, rod_radius, rod.height))), chart.length};
}

double ends(const Rod& rod, double of_sphere) { return rod.closed ? 0 : of_sphere; }

class SolidMesh : public testing::TestWithParam<Rod> {};

INSTANTIATE_TEST_SUITE_P(Rods, SolidMesh,
                         testing::Values(straight_on_plane(), ring_on_plane(), ring_around_cylinder(),
                                         ring_around_sphere(), on_egg_crate()),
                         [](const auto& rod) {
                           std::string name = rod.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// Measured: volume within 0.05 %, area 0.1 %, distance 0.05 voxels.
TEST_P(SolidMesh, HasTheVolumeTheAreaAndThePlaceOfARod) {
  const Rod& rod = GetParam();
  for (const double voxel : {rod_radius / 4, rod_radius / 8}) {
    const auto [mesh, length] = make(rod, voxel);
    const double r = rod_radius;
    const double volume = pi * r * r * length + ends(rod, 4 * pi / 3 * r * r * r);
    const double area = 2 * pi * r * length + ends(rod, 4 * pi * r * r);
    const auto [found_volume, found_area] = test::extent_of(mesh);
    double farthest = 0;
    for (const Vec3f& p : mesh.positions)
      if (rod.distance) farthest = std::max(farthest, std::abs(rod.distance(p.cast<double>())));
    std::cout << fmt::format("{}, voxel {}: volume {:+.4f} %, area {:+.4f} %, {:.3f} voxels off\n", rod.name,
                             voxel, 100 * (found_volume / volume - 1), 100 * (found_area / area - 1),
                             farthest / voxel);
    EXPECT_NEAR(found_volume, volume, 0.003 * volume);
    EXPECT_NEAR(found_area, area, 0.005 * area);
    EXPECT_LE(farthest, 0.6 * voxel);
  }
}

TEST_P(SolidMesh, IsClosedAndOrientedAndOfGoodTriangles) {
  const Rod& rod = GetParam();
  const TriangleMesh mesh = make(rod, rod_radius / 6).mesh;
  const test::Edges edges = test::edges_of(mesh);
  EXPECT_EQ(edges.open, 0u);
  EXPECT_EQ(edges.multi, 0u);
  EXPECT_EQ(edges.euler, rod.closed ? 0 : 2);
  const std::vector<double> angles = test::angles_of(mesh);
  std::cout << fmt::format("least angle {:.1f}, 1 in 100 below {:.1f}\n", angles[0],
                           angles[angles.size() / 100]);
  EXPECT_GE(angles[angles.size() / 100], 15);
  EXPECT_GE(angles[0], 1);
}

/// A place as two rods that touch each other see it: they run along x from 0 to 0.3, their middles at y = -r
/// and r.
Vec3d seen_by_rods(const Vec3d& p) { return Eigen::AngleAxisd(0.5, Vec3d(1, 2, 3).normalized()) * p; }

double beyond_rods(const Vec3d& q) { return q.x() - std::clamp(q.x(), 0., 0.3); }

double to_touching_rods(const Vec3d& p) {
  const Vec3d q = seen_by_rods(p);
  const auto to_rod = [&](double y) { return Vec3d(beyond_rods(q), q.y() - y, q.z()).norm() - rod_radius; };
  return std::min(to_rod(-rod_radius), to_rod(rod_radius));
}

StrokeSolid solid_in_box(const std::function<double(const Vec3d&)>& distance, double voxel, int first,
                         int end) {
  constexpr int side = VoxelBlock::side;
  const double most = VoxelBlock::half_width * voxel;
  std::vector<VoxelBlock> all;
  for (int i = first; i < end; ++i)
    for (int j = first; j < end; ++j)
      for (int k = first; k < end; ++k) {
        VoxelBlock& block = all.emplace_back();
        block.origin = side * Eigen::Vector3i(i, j, k);
        for (int v = 0; v < VoxelBlock::voxels; ++v) {
          const Eigen::Vector3i at = block.origin + Eigen::Vector3i(v / 64, v / 8 % 8, v % 8);
          block.values[static_cast<std::size_t>(v)] =
              static_cast<float>(std::clamp(distance(voxel * at.cast<double>()), -most, most));
        }
      }
  return {voxel, std::move(all)};
}

// The valley where two rods touch is a cusp. It is filled as far as a ball of a voxel does not reach into it.
TEST(CuspsOfSolids, AreFilledAndAllElseStays) {
  const double voxel = rod_radius / 5.3;
  const StrokeSolid solid = solid_in_box(to_touching_rods, voxel, -5, 6);
  const TriangleMesh mesh = mesh_of(solid);
  EXPECT_GE(test::angles_of(mesh)[0], 5);
  // A ball of radius v between two rods of radius r comes to this far from the plane of their middles.
  const double reached = std::sqrt(2 * rod_radius * voxel + voxel * voxel) - voxel;
  std::size_t in_valley = 0;
  for (const Vec3f& at : mesh.positions) {
    const Vec3d q = seen_by_rods(at.cast<double>());
    const double from_middle = std::hypot(beyond_rods(q), q.z());
    if (std::abs(q.y()) < voxel) {
      ++in_valley;
      EXPECT_GE(from_middle, reached - 0.5 * voxel) << q.transpose();
    } else if (from_middle > reached + voxel) {
      EXPECT_LE(std::abs(to_touching_rods(at.cast<double>())), 0.2 * voxel) << q.transpose();
    }
  }
  EXPECT_GT(in_valley, 20u);
  const ThreadLimit one(1);
  EXPECT_TRUE(mesh_of(solid).positions == mesh.positions);
}

TEST(SolidMeshBits, DoNotDependOnThreads) {
  const Rod rod = ring_on_plane();
  const TriangleMesh all = make(rod, rod_radius / 5).mesh;
  const ThreadLimit one(1);
  const TriangleMesh alone = make(rod, rod_radius / 5).mesh;
  EXPECT_TRUE(all.positions == alone.positions);
  EXPECT_TRUE(all.triangles == alone.triangles);
}

}  // namespace
}  // namespace burin
