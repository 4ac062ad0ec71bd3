#include <burin/deform/evaluate/displacement.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

TEST(Displacement, FollowsTheFrame) {
  const Vec3f base(1, 2, 3), e1 = Vec3f::UnitX(), n = Vec3f::UnitZ();
  EXPECT_EQ(displaced(base, e1, n, {1, 0, 0}), Vec3f(2, 2, 3));
  EXPECT_EQ(displaced(base, e1, n, {0, 1, 0}), Vec3f(1, 3, 3)) << "e2 = n x e1 is the left of the travel";
  EXPECT_EQ(displaced(base, e1, n, {0, 0, 1}), Vec3f(1, 2, 4));
}

TEST(Displacement, NoneKeepsTheBitsOfTheBase) {
  const Vec3f moved = displaced(Vec3f(-0.0f, -0.0f, -0.0f), Vec3f::UnitX(), Vec3f::UnitZ(), {0, -0.0f, 0});
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::signbit(moved[k]));
}

}  // namespace
}  // namespace burin
