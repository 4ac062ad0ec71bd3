#include <burin/stroke/curve/curve_ground.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "support/relief.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double ground_radius = 0.3, height = 0.02;

/// A square in the plane z = 0 with bumps, which its base surface hardly has.
TriangleMesh bumpy_square() {
  TriangleMesh mesh = test::plane(1, 0.015, 7);
  for (Vec3f& at : mesh.positions) {
    const double x = static_cast<double>(at.x()) / ground_radius,
                 y = static_cast<double>(at.y()) / ground_radius;
    at.z() = static_cast<float>(height * test::egg_crate(x, y));
  }
  return mesh;
}

struct Bumps {
  Bumps() { EXPECT_TRUE(base.set_radius(ground_radius)); }

  Surface surface = make_surface(bumpy_square());
  Picker picker{surface};
  SurfaceLevels levels{surface};
  BaseSurface base{surface, levels};
  CurveGround ground{surface, picker, &base};
};

TEST(CurveGround, IsMetByARayWhereThatMeetsTheBaseSurface) {
  const Bumps on;
  const Vec3f direction = Vec3f(1, 0.3F, -0.8F).normalized();
  float shift = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3f origin = Vec3f(-0.3F + 0.015F * static_cast<float>(i), 0.013F, 0) - 2 * direction;
    const auto met = on.ground.pick({origin, direction});
    ASSERT_TRUE(met);
    EXPECT_LT((met->at.position - origin).cross(direction).norm(), 2e-3 * height) << "ray " << i;
    shift = std::max(shift, (met->at.position - met->on_surface.position).norm());
  }
  EXPECT_GT(shift, height / 2) << "the rays meet no bumps";
}

TEST(CurveGround, IsClosestBelowAPositionWhateverBumpsAreBeside) {
  const Bumps on;
  for (int i = 0; i < 40; ++i) {
    const Vec3f position(-0.3F + 0.015F * static_cast<float>(i), 0.013F, 0.04F);
    const auto closest = on.ground.closest(position, 0.3F);
    ASSERT_TRUE(closest);
    const Vec3f step = position - closest->at.position;
    EXPECT_LT((step - step.dot(closest->normal) * closest->normal).norm(), 2e-3 * height) << "position " << i;
  }
}

/// A groove of the plane, 0.02 wide and 0.012 deep, crossed with one sample on each side of it.
TEST(CurveGround, GoesOnAcrossAGrooveThatIsNarrowForTheBrush) {
  const Surface surface =
      make_surface(test::patch({-0.2, 0.2, -0.2, 0.2, 80, 80, false, 0, 0.3}, [](double u, double v) {
        return Vec3d(u, v, std::min(0.0, 1.2 * std::abs(u) - 0.012));
      }));
  const Picker picker(surface);
  const CurveGround ground(surface, picker);
  const auto left = *ground.closest(Vec3f(-0.01F, 0, 0), 1), right = *ground.closest(Vec3f(0.01F, 0, 0), 1);
  EXPECT_TRUE(ground.connects(left, right, 0.025));
  EXPECT_FALSE(ground.connects(left, right, 0.01)) << "deeper than half the radius";
}

}  // namespace
}  // namespace burin
