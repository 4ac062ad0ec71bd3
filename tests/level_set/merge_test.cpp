// Rods joined with surfaces and taken from them, against closed forms.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/surface/surface_patch.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>

#include "level_set/ground.h"
#include "support/mesh_fault.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

using std::numbers::pi;

constexpr double merged_rod_radius = 0.05;

using test::Ground;

std::vector<Vec3d> ring(double radius) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 240; ++i) {
    const double angle = 2 * pi * i / 240;
    samples.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return samples;
}

/// A closed rod whose middle runs along the stroke, half sunk.
Ground half_sunk(TriangleMesh mesh, double ring_radius, double voxel) {
  Ground ground(std::move(mesh), ring(ring_radius), true);
  ground.lay(test::rod(ground.chart, merged_rod_radius, 0), -merged_rod_radius, merged_rod_radius, voxel);
  return ground;
}

/// Of the section of a half-sunk rod outside of flat ground with a fillet of this radius on either side: a
/// ball that touches both has its middle at the height of its radius, and at the sum of both radii from the
/// rod's middle.
double section_outside(double blend) {
  const double r = merged_rod_radius, x = std::sqrt(r * (r + 2 * blend)), angle = std::atan2(blend, x);
  const double fillet = x * blend / 2 - r * r * angle / 2 - blend * blend * (pi / 2 - angle) / 2;
  return pi * r * r / 2 + 2 * fillet;
}

/// Of the part of the rod around the unit sphere's equator that is outside of it, or inside: the rod is round
/// in (arc, height).
double rod_beside_sphere(bool outside) {
  const int steps = 20000;
  double volume = 0;
  for (int i = 0; i < steps; ++i) {
    const double h = (i + 0.5) / steps * merged_rod_radius * (outside ? 1 : -1);
    volume += (1 + h) * (1 + h) * 2 * std::sin(std::sqrt(merged_rod_radius * merged_rod_radius - h * h));
  }
  return 2 * pi * volume * merged_rod_radius / steps;
}

void expect_good(const char* what, const Ground& ground, const SurfacePatch& patch, double volume,
                 std::size_t open_edges, long euler_added) {
  const TriangleMesh before = ground.before(), after = ground.after(patch);
  const double added = test::extent_of(after).volume - test::extent_of(before).volume;
  const std::vector<double> angles = test::angles_of(ground.fresh(patch));
  std::cout << fmt::format("{}: volume {:+.3f} %, angles from {:.1f}, 1 in 100 below {:.1f}\n", what,
                           100 * (added / volume - 1), angles[0], angles[angles.size() / 100]);
  EXPECT_NEAR(added, volume, 0.005 * std::abs(volume)) << what;
  EXPECT_GE(angles[0], 5) << what;
  EXPECT_GE(angles[angles.size() / 100], 15) << what;
  const test::Edges edges = test::edges_of(after);
  EXPECT_EQ(edges.open, open_edges) << what;
  EXPECT_EQ(edges.multi, 0u) << what;
  EXPECT_EQ(edges.euler, test::edges_of(before).euler + euler_added) << what;
}

// Measured: within 0.25 %.
TEST(Merge, HasTheVolumeOfARingOnAPlane) {
  for (const double blend : {0., 0.02, 0.04}) {
    const Ground ground = half_sunk(test::plane(1, 0.02, 7), 0.5, merged_rod_radius / 5);
    const std::size_t open = test::edges_of(ground.before()).open;
    const double volume = pi * section_outside(blend);
    expect_good("union", ground, ground.merged(SolidOperation::unite, blend), volume, open, 0);
    expect_good("difference", ground, ground.merged(SolidOperation::difference, blend), -volume, open, 0);
  }
}

TEST(Merge, HasTheVolumeOfARingAroundASphere) {
  const Ground ground = half_sunk(test::sphere(6, 0.2, 4), 1, merged_rod_radius / 5);
  expect_good("union", ground, ground.merged(SolidOperation::unite, 0), rod_beside_sphere(true), 0, 0);
  expect_good("difference", ground, ground.merged(SolidOperation::difference, 0), -rod_beside_sphere(false),
              0, 0);
}

/// A closed rod that rests on the surface, sunk by a fifth of its radius.
Ground resting(TriangleMesh mesh, double ring_radius, double voxel) {
  Ground ground(std::move(mesh), ring(ring_radius), true);
  ground.lay(test::rod(ground.chart, merged_rod_radius, 0.8 * merged_rod_radius), 0, 2 * merged_rod_radius,
             voxel);
  return ground;
}

// The gap beside the line in which both meet is narrower than voxels: nothing of it may be left as a ragged
// edge or as tunnels.
TEST(Merge, ClosesGapsThatVoxelsCannotHold) {
  for (const double voxel : {merged_rod_radius / 4, merged_rod_radius / 7}) {
    const Ground ground = resting(test::sphere(6, 0.2, 4), 1, voxel);
    for (const auto operation : {SolidOperation::unite, SolidOperation::difference}) {
      const SurfacePatch patch = ground.merged(operation, 0);
      const test::Edges edges = test::edges_of(ground.after(patch));
      EXPECT_EQ(edges.euler, 2);
      EXPECT_EQ(edges.open + edges.multi, 0u);
      EXPECT_GE(test::angles_of(ground.fresh(patch))[0], 10);
    }
  }
}

// Edges of the surface from half a voxel to fifteen voxels.
TEST(Merge, MakesNoSliversWhateverTheSurfacesEdges) {
  for (const auto& [level, voxel] : {std::pair(7, 0.02), {5, 0.02}, {4, 0.0075}}) {
    const Ground ground = half_sunk(test::sphere(level, 0.2, 4), 1, voxel);
    for (const double blend : {0., 0.03}) {
      const std::vector<double> angles =
          test::angles_of(ground.fresh(ground.merged(SolidOperation::unite, blend)));
      EXPECT_GE(angles[0], 5) << level << ' ' << blend;
      EXPECT_GE(angles[angles.size() / 100], 15) << level << ' ' << blend;
    }
  }
}

// What is left is the inner half of the rod.
TEST(Merge, LeavesTheIntersection) {
  const Ground ground = half_sunk(test::sphere(6, 0.2, 4), 1, merged_rod_radius / 5);
  const TriangleMesh after = ground.after(ground.merged(SolidOperation::intersection, 0));
  EXPECT_NEAR(test::extent_of(after).volume, rod_beside_sphere(false), 0.005 * rod_beside_sphere(false));
  const test::Edges edges = test::edges_of(after);
  EXPECT_EQ(edges.open, 0u);
  EXPECT_EQ(edges.euler, 0);
}

// An arch that stands on the surface with both ends.
TEST(Merge, AHandleAddsOneToTheGenus) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 60; ++i) {
    const double angle = -0.5 + i / 60.;
    samples.push_back({std::cos(angle), std::sin(angle), 0});
  }
  Ground ground(test::sphere(6, 0.2, 4), samples, false);
  const double length = ground.chart.length;
  const DistanceToSolid arch = [length](std::span<const ShellPoint> points, std::span<float> distances) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double t = points[i].t - length / 2, d = static_cast<double>(points[i].d),
                   h = static_cast<double>(points[i].h);
      const double from_arch = std::hypot(t, h + 0.1) - 0.3;
      distances[i] = static_cast<float>(std::hypot(from_arch, d) - 0.04);
    }
  };
  ground.lay(arch, -0.1, 0.3, 0.01);
  const TriangleMesh after = ground.after(ground.merged(SolidOperation::unite, 0.02));
  const test::Edges edges = test::edges_of(after);
  EXPECT_EQ(edges.euler, 0) << "a sphere with a handle";
  EXPECT_EQ(edges.open + edges.multi, 0u);
}

TEST(Merge, KeepsVerticesFarFromTheSolid) {
  const double voxel = merged_rod_radius / 5, blend = 0.02;
  const Ground ground = half_sunk(test::sphere(6, 0.2, 4), 1, voxel);
  const PatchedSurface result = patched(ground.charted.surface, ground.merged(SolidOperation::unite, blend));
  std::vector<bool> kept(ground.charted.surface.vertex_count(), false);
  for (Index v = 0; v < result.surface.vertex_count(); ++v) {
    const Index from = result.came_from[v];
    if (from >= kept.size()) continue;
    kept[from] = true;
    EXPECT_EQ(result.surface.positions[v], ground.charted.surface.positions[from]);
  }
  std::size_t far = 0;
  for (Index v = 0; v < kept.size(); ++v) {
    const Vec3d p = ground.charted.surface.positions[v].cast<double>();
    if (std::abs(std::asin(p.z())) - merged_rod_radius < blend + 2 * voxel) continue;
    ++far;
    EXPECT_TRUE(kept[v]) << p.transpose();
  }
  EXPECT_GT(far, kept.size() / 2) << "the sample is not representative";
}

// A cube of 12 triangles: sides that are long beside the cut are split.
TEST(Merge, CutsIntoLargeTriangles) {
  TriangleMesh cube;
  for (int i = 0; i < 8; ++i) cube.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 0 : -2);
  for (const auto& [a, b, c, d] : {std::array<Index, 4>{4, 5, 7, 6},
                                   {1, 0, 2, 3},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {1, 3, 7, 5},
                                   {0, 4, 6, 2}}) {
    cube.triangles.push_back({a, b, c});
    cube.triangles.push_back({a, c, d});
  }
  ASSERT_NEAR(test::extent_of(cube).volume, 8, 1e-6);
  Ground fine = half_sunk(test::plane(1, 0.02, 7), 0.5, merged_rod_radius / 4);
  const Surface surface = make_surface(cube);
  const Picker picker(surface);
  const SurfacePatch patch = merge_solid({surface, picker, *fine.solid, SolidOperation::difference, 0}).patch;
  const PatchedSurface result = patched(surface, patch);
  const TriangleMesh after{result.surface.positions, result.surface.triangles, {}};
  EXPECT_NEAR(test::extent_of(after).volume, 8 - pi * section_outside(0), 0.005 * pi * section_outside(0));
  EXPECT_EQ(test::edges_of(after).open, 0u);
  EXPECT_GE(test::angles_of(after)[0], 5);
}

TEST(Merge, RefusesASurfaceThatIsOpenThere) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 40; ++i) samples.push_back({0.5 + i / 80., 0.1, 0});
  Ground ground(test::plane(1, 0.02, 7), samples, false);
  ground.lay(test::rod(ground.chart, merged_rod_radius, 0), -merged_rod_radius, merged_rod_radius, 0.01);
  try {
    ground.merged(SolidOperation::unite, 0);
    FAIL() << "an open surface was taken";
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("the surface is open at (1, ")) << error.what();
  }
}

/// Strands that wind around each other, touch their neighbours, and rest on the surface.
DistanceToSolid strands(double radius, double lay) {
  constexpr int count = 6;
  const double ring_radius = 2 * radius;
  return [=](std::span<const ShellPoint> points, std::span<float> distances) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double y = static_cast<double>(points[i].d), z = static_cast<double>(points[i].h) - 3 * radius;
      double least = 1;
      for (int k = 0; k < count; ++k) {
        const double angle = 2 * pi * (points[i].t / lay + static_cast<double>(k) / count);
        least =
            std::min(least, std::hypot(y - ring_radius * std::cos(angle), z - ring_radius * std::sin(angle)));
      }
      const double beyond = std::max(0.02 - points[i].t, points[i].t - 0.38);
      distances[i] = static_cast<float>(std::max(least - radius, beyond));
    }
  };
}

// Between strands and surface there are gaps of any width, which close somewhere.
TEST(Merge, FillsWhatIsTooThinForVoxels) {
  constexpr double strand = 0.022;
  std::vector<Vec3d> arc;
  for (int i = 0; i <= 40; ++i) arc.emplace_back(std::cos(0.01 * i), std::sin(0.01 * i), 0);
  Ground ground(test::sphere(5, 0.2, 4), arc, false);
  ground.lay(strands(strand, 0.25), 0, 6 * strand, strand / 3);
  for (const double blend : {0., 0.3 * strand}) {
    const SurfacePatch patch = ground.merged(SolidOperation::unite, blend);
    EXPECT_EQ(test::mesh_fault(ground.after(patch)), "");
    EXPECT_GE(test::angles_of(ground.fresh(patch))[0], 5);
  }
}

TEST(Merge, RefusesABlendThatNeedsTooMuchMemory) {
  const Ground ground = half_sunk(test::sphere(5, 0.2, 4), 1, merged_rod_radius / 3);
  try {
    ground.merged(SolidOperation::unite, 20);
    FAIL() << "a blend of 20 was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a smaller blend"), std::string::npos) << error.what();
  }
}

TEST(Merge, HasTheSameBitsForAnyNumberOfThreads) {
  const Ground ground = half_sunk(test::sphere(5, 0.2, 4), 1, merged_rod_radius / 3);
  const SurfacePatch all = ground.merged(SolidOperation::unite, 0.02);
  const ThreadLimit one(1);
  const SurfacePatch alone = ground.merged(SolidOperation::unite, 0.02);
  EXPECT_TRUE(all.positions == alone.positions);
  EXPECT_TRUE(all.triangles == alone.triangles);
  EXPECT_TRUE(all.removed == alone.removed);
}

}  // namespace
}  // namespace burin
