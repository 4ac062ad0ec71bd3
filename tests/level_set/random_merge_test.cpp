// Strokes at random on a closed surface with relief, judged by CGAL.
#include <burin/base/error.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "level_set/ground.h"
#include "support/mesh_fault.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

/// A sphere with bumps, of edges about 0.035 long.
TriangleMesh bumpy() {
  TriangleMesh mesh = test::sphere(5, 0.2, 4);
  for (Vec3f& p : mesh.positions)
    p *= 1 + 0.03F * std::sin(5 * p.x()) * std::sin(6 * p.y() + 1) * std::cos(4 * p.z());
  return mesh;
}

/// A stroke over the sphere that turns at random, and may cross itself.
std::vector<Vec3d> wander(std::mt19937& random) {
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Vec3d at = Vec3d(share() - 0.5, share() - 0.5, share() - 0.5).normalized(), way = at.unitOrthogonal();
  double turn = 0;
  std::vector<Vec3d> samples;
  for (int i = 0; i < 60; ++i) {
    samples.push_back(at);
    turn = 0.9 * turn + 0.08 * (share() - 0.5) + 0.02;
    way = (Eigen::AngleAxisd(turn, at) * way).eval();
    at = (at + 0.02 * way).normalized();
    way = (way - way.dot(at) * at).normalized();
  }
  return samples;
}

TEST(RandomMerges, AreClosedAndDoNotIntersectThemselves) {
  constexpr std::uint32_t seed = 11;
  constexpr int strokes = 20;
  constexpr double rod_radius = 0.06;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  int merged = 0;
  double least = 180;
  for (int i = 0; i < strokes; ++i) {
    test::Ground ground(bumpy(), wander(random), false);
    const double height = 0.03 * static_cast<double>(i % 4) - 0.03;
    ground.lay(test::rod(ground.chart, rod_radius, height), height - rod_radius, height + rod_radius,
               rod_radius / 4);
    const SolidOperation operation = i % 2 == 0 ? SolidOperation::unite : SolidOperation::difference;
    const double blend = i % 3 == 0 ? 0 : 0.02;
    try {
      const SurfacePatch patch = ground.merged(operation, blend);
      EXPECT_EQ(test::mesh_fault(ground.after(patch)), "") << "stroke " << i;
      least = std::min(least, test::angles_of(ground.fresh(patch))[0]);
      ++merged;
    } catch (const Error& error) {
      std::cout << "stroke " << i << ": " << error.what() << '\n';
    }
  }
  std::cout << merged << " of " << strokes << " merged, least angle " << least << '\n';
  EXPECT_GE(merged, strokes - 1);
  EXPECT_GE(least, 1);
}

}  // namespace
}  // namespace burin
