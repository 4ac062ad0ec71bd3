#include <burin/surface/picking/ray_triangle.h>
#include <gtest/gtest.h>

#include <random>

#include "surface/test_meshes.h"

namespace burin {
namespace {

constexpr unsigned seed = 20130514;

Surface corner_triangle() { return make_surface({{{1, 0, 0}, {0, 2, 0}, {0, 0, 4}}, {{0, 1, 2}}}); }

/// The place that a hit names by its weights.
Vec3d weighted(const Surface& surface, const TriangleHit& hit) {
  const auto corner = [&](int i) -> Vec3d {
    return surface.positions[surface.triangles[0][i]].cast<double>();
  };
  return (1 - hit.u - hit.v) * corner(0) + hit.u * corner(1) + hit.v * corner(2);
}

TEST(TriangleRay, MeetsTheirCommonPlace) {
  const Surface surface = corner_triangle();
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-1, 2);
  int hits = 0, misses = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3f origin(coordinate(random), coordinate(random), coordinate(random));
    const Vec3f direction = 3 * Vec3f(coordinate(random), coordinate(random), coordinate(random));
    const auto hit = TriangleRay({origin, direction}).meet(surface, 0);
    // The triangle is what x + y / 2 + z / 4 = 1 leaves in the positive octant.
    const Vec3d plane(1, 0.5, 0.25), from = origin.cast<double>(), along = direction.cast<double>();
    const double distance = (1 - plane.dot(from)) / plane.dot(along);
    const Vec3d place = from + distance * along;
    ASSERT_EQ(hit.has_value(), distance >= 0 && place.minCoeff() >= 0) << "seed " << seed << ", ray " << i;
    ++(hit ? hits : misses);
    if (!hit) continue;
    EXPECT_NEAR(hit->distance, distance, 1e-12 * (1 + distance));
    EXPECT_LT((weighted(surface, *hit) - place).norm(), 1e-12);
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 100);
}

TEST(TriangleRay, MeetsNothingInTheTrianglesPlaneOrWithoutADirection) {
  const Surface surface = corner_triangle();
  EXPECT_FALSE(TriangleRay({{3, -4, 0}, {-1, 2, 0}}).meet(surface, 0));
  EXPECT_FALSE(TriangleRay({{0, 0, 0}, {0, 0, 0}}).meet(surface, 0));
}

/// The torus, closed; its tube's centre line lies well inside.
TEST(TriangleRay, LeavesAClosedSurfaceThroughAnyEdgeAndCorner) {
  const Surface surface = make_surface(test::torus(60, 30));
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(0, 1);
  const Vec3f inside(2, 0.01f, 0.02f);
  const auto leaves = [&](const Vec3f& target) {
    const TriangleRay ray({inside, target - inside});
    for (Index triangle = 0; triangle < surface.triangles.size(); ++triangle)
      if (ray.meet(surface, triangle)) return true;
    return false;
  };
  for (const Triangle& triangle : surface.triangles) {
    const Vec3f &a = surface.positions[triangle[0]], &b = surface.positions[triangle[1]];
    ASSERT_TRUE(leaves(a));
    ASSERT_TRUE(leaves(a + share(random) * (b - a))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace burin
