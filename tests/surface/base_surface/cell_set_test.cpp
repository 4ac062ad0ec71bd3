#include <burin/surface/base_surface/cell_set.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace burin {
namespace {

TEST(CellSet, HoldsWhatIsWithinTheDistanceAndLittleMore) {
  constexpr unsigned seed = 11;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  const auto place = [&] {
    const auto share = [&] { return static_cast<float>(random()) / 2147483648.F - 1; };
    return Vec3f(5 * share(), 5 * share(), 5 * share());
  };
  const Vec3f a(0.1F, -0.2F, 0.3F), b(2, 2, -2);
  CellSet near(0.8);
  near.add(a);
  near.add(b);
  int within = 0, beyond = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3f at = place();
    const float distance = std::min((at - a).norm(), (at - b).norm());
    // Cells are half the distance wide, two more on each side: the corner is sqrt(3) * 1.5 distances away.
    ASSERT_TRUE(near.holds(at) || distance > 0.8F);
    ASSERT_FALSE(near.holds(at) && distance > 2.6F * 0.8F);
    within += distance <= 0.8F;
    beyond += distance > 2.6F * 0.8F;
  }
  EXPECT_GT(within, 20);
  EXPECT_GT(beyond, 5000);
}

}  // namespace
}  // namespace burin
