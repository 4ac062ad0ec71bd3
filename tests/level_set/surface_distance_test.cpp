// Checks that searches among the triangles near a ball give the bits of searches among all.
#include <burin/level_set/surface_distance.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/shapes.h"

namespace burin {
namespace {

constexpr unsigned seed = 20261201;

/// A bumpy sphere of radius 1, on which many points have more than one foot.
TriangleMesh bumpy_sphere() {
  TriangleMesh mesh = test::sphere(4, 0.3, 5);
  for (Vec3f& p : mesh.positions) p *= 1 + 0.1F * std::sin(9 * p.x()) * std::cos(8 * p.y());
  return mesh;
}

class Places {
 public:
  Vec3d within(double radius) {
    const double x = even_(generator_), y = even_(generator_), z = even_(generator_);
    return radius / std::sqrt(3.) * Vec3d(x, y, z);
  }

 private:
  std::mt19937 generator_{seed};
  std::uniform_real_distribution<double> even_{-1, 1};
};

struct Bumpy {
  Surface surface = make_surface(bumpy_sphere());
  Picker picker{surface};
  SurfaceDistance distance{surface, picker};
};

constexpr std::size_t all = 1'000'000;

TEST(SurfaceDistance, IsTheSameAmongTrianglesNearABall) {
  const Bumpy bumpy;
  Places places;
  int inside = 0, outside = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3d middle = places.within(2);
    const double radius = 0.02 + 0.1 * (i % 4), at_middle = bumpy.distance(middle);
    const auto near = bumpy.distance.around(middle, at_middle, radius, all);
    ASSERT_TRUE(near);
    Index triangle = no_index;
    for (int k = 0; k < 20; ++k) {
      const Vec3d p = middle + places.within(radius);
      const double exact = bumpy.distance(p);
      ASSERT_EQ(bumpy.distance(p, *near, triangle), exact) << "seed " << seed << ": " << p.transpose();
      ++(exact < 0 ? inside : outside);
      const NearTriangles fewer = SurfaceDistance::around(*near, p, exact, radius / 20);
      const Vec3d q = p + places.within(radius / 20);
      Index other = triangle;
      ASSERT_EQ(bumpy.distance(q, fewer, other), bumpy.distance(q))
          << "seed " << seed << ": " << q.transpose();
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 500);
}

TEST(SurfaceDistance, HasNoListOfTooManyTriangles) {
  const Bumpy bumpy;
  const Vec3d middle(0, 0, 0.5);
  EXPECT_FALSE(bumpy.distance.around(middle, bumpy.distance(middle), 0.3, 100));
  EXPECT_TRUE(bumpy.distance.around(middle, bumpy.distance(middle), 0.3, bumpy.surface.triangles.size()));
}

}  // namespace
}  // namespace burin
