#include <burin/stroke/curve/pen_spline.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

constexpr MonotoneCubic::Intervals even{1, 1, 1};

// Steffen 1990, equation 11: the parabola's slope through three points, and twice the lesser secant at most.
TEST(MonotoneCubic, HasSteffensSlopes) {
  const auto slope = [](const MonotoneCubic& cubic, double s) {
    constexpr double step = 1e-6;
    return (cubic.at(s + step) - cubic.at(s)) / step;
  };
  const MonotoneCubic gentle(even, 0, 1, 2.5, 4.5), steep(even, -9, 1, 2, 12);
  EXPECT_NEAR(slope(gentle, 0), 1.25, 1e-4);
  EXPECT_NEAR(slope(gentle, 1 - 1e-6), 1.75, 1e-4);
  EXPECT_NEAR(slope(steep, 0), 2, 1e-4) << "the parabola's would be 5.5";
  EXPECT_NEAR(slope(steep, 1 - 1e-6), 2, 1e-4);
}

TEST(MonotoneCubic, RisesAllTheWayBetweenSteepNeighbours) {
  const MonotoneCubic cubic(even, -9, 1, 2, 12);
  double before = cubic.at(0);
  EXPECT_EQ(before, 1);
  for (int i = 1; i <= 100; ++i) {
    const double here = cubic.at(i / 100.);
    ASSERT_GT(here, before) << i;
    before = here;
  }
  EXPECT_EQ(before, 2);
}

TEST(MonotoneCubic, IsLevelWhereTheValueTurns) {
  const MonotoneCubic cubic(even, 0, 1, 0, 1);
  EXPECT_NEAR(cubic.at(1e-4), 1, 1e-7);
  EXPECT_NEAR(cubic.at(1 - 1e-4), 0, 1e-7);
}

// Third order: a parabola with uneven intervals is met as closely as its slopes at the ends allow.
TEST(MonotoneCubic, IsTheParabolaItself) {
  const auto parabola = [](double x) { return 3 + 2 * x + 0.25 * x * x; };
  const MonotoneCubic cubic({0.5, 2, 1}, parabola(0), parabola(0.5), parabola(2.5), parabola(3.5));
  for (double s = 0; s <= 1; s += 0.1) EXPECT_NEAR(cubic.at(s), parabola(0.5 + 2 * s), 1e-12);
  const MonotoneCubic at_the_begin({0, 2, 1}, 0, parabola(0.5), parabola(2.5), parabola(3.5));
  for (double s = 0; s <= 1; s += 0.1) EXPECT_NEAR(at_the_begin.at(s), parabola(0.5 + 2 * s), 1e-12);
}

}  // namespace
}  // namespace burin
