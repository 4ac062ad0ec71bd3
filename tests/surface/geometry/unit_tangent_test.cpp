#include <burin/surface/geometry/unit_tangent.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(UnitTangent, IsUnitForDirectionsOfAnyLength) {
  const Vec3f normal = Vec3f(1, 2, 3).normalized(), exact = Vec3f(3, 0, -1).normalized();
  for (const float length : {1e-40F, 1e-23F, 1e-18F, 1e-14F, 1.F, 1e15F}) {
    EXPECT_LE((unit_tangent(length * (exact + 2 * normal), normal) - exact).norm(), 1e-4F) << length;
  }
}

TEST(UnitTangent, IsAnyTangentWhereNothingIsLeft) {
  for (const Vec3f& direction : {Vec3f(0, 0, 0), Vec3f(0, 0, 1e-30F), Vec3f(0, 0, -5)}) {
    const Vec3f tangent = unit_tangent(direction, Vec3f::UnitZ());
    EXPECT_NEAR(tangent.norm(), 1, 1e-6F);
    EXPECT_NEAR(tangent.z(), 0, 1e-6F);
  }
}

}  // namespace
}  // namespace burin
