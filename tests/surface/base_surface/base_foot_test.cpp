#include <burin/surface/base_surface/base_foot.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "support/shapes.h"

namespace burin {
namespace {

std::vector<Index> all_vertices(const Surface& surface) {
  std::vector<Index> vertices(surface.vertex_count());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  return vertices;
}

// An egg crate of 0.02 on a cylinder of radius 1. Of the egg crate's own mean curvatures, which are up to 40
// either way, next to nothing is left.
TEST(BaseFoot, OfACylinderWithBumpsIsOnTheCylinder) {
  constexpr double radius = 0.4, height = 0.02;
  constexpr int waves = 45;  // around: of 0.35 radii
  TriangleMesh mesh = test::shuffled(test::cylinder(1, 1.5, 0.02, 0.3, 3), 4);
  for (Vec3f& at : mesh.positions) {
    const double angle = std::atan2(at.y(), at.x());
    const double bump = std::sin(waves * angle) * std::sin(waves * static_cast<double>(at.z()));
    at.head<2>() *= static_cast<float>(1 + height * bump);
  }
  const Surface surface = make_surface(mesh);
  const SurfaceLevels levels(surface);
  BaseSurface base(surface, levels);
  ASSERT_TRUE(base.set_radius(radius));
  double off = 0, aside = 0, bent = 0, highest = 0;
  for (const Index vertex : all_vertices(surface)) {
    const Vec3f& at = surface.positions[vertex];
    if (std::abs(at.z()) > 0.8F) continue;
    const Vec3f place = base_position(base, surface, vertex);
    const Vec2f outward = at.head<2>().normalized();
    highest = std::max(highest, std::abs(static_cast<double>(at.head<2>().norm()) - 1));
    off = std::max(off, std::abs(static_cast<double>(place.head<2>().norm()) - 1));
    aside = std::max(aside, static_cast<double>((place.head<2>().normalized() - outward).norm()) +
                                std::abs(static_cast<double>(place.z() - at.z())));
    bent = std::max(bent, std::abs(static_cast<double>(base_mean_curvature(base, surface, vertex)) - 0.5));
  }
  EXPECT_GT(highest, 0.9 * height);
  EXPECT_LT(off, 0.05 * height);
  EXPECT_LT(aside, 0.05 * height);
  EXPECT_LT(bent, 0.005 * height * waves * waves);
}

// Convex seen from outside is positive: a saddle has none, the inside of a cylinder a negative one.
TEST(BaseFoot, HasMeanCurvaturesOfEitherSign) {
  for (const auto& [bend_x, bend_y] : {std::pair(0.5, 0.5), {0.5, -0.5}, {-0.5, 0.}, {-0.5, -0.25}}) {
    const Surface surface = make_surface(
        test::patch({.u_min = -2, .u_max = 2, .v_min = -2, .v_max = 2, .cells_u = 80, .cells_v = 80},
                    [&](double x, double y) { return Vec3d(x, y, -(bend_x * x * x + bend_y * y * y) / 2); }));
    const SurfaceLevels levels(surface);
    BaseSurface base(surface, levels);
    ASSERT_TRUE(base.set_radius(0.5));
    std::vector<Index> middle;
    for (const Index vertex : all_vertices(surface))
      if (surface.positions[vertex].head<2>().norm() < 0.1F) middle.push_back(vertex);
    ASSERT_GT(middle.size(), 5U);
    for (const Index vertex : middle)
      EXPECT_NEAR(base_mean_curvature(base, surface, vertex), (bend_x + bend_y) / 2, 0.02);
  }
}

}  // namespace
}  // namespace burin
