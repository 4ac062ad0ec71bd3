#include <burin/surface/geometry/quadratic_fit.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(BumpWeight, FallsFromTheMiddleToTheRim) {
  EXPECT_EQ(bump_weight(0), 1);
  EXPECT_EQ(bump_weight(0.5), 0.125);
  EXPECT_EQ(bump_weight(1), 0);
  EXPECT_EQ(bump_weight(2), 0);
}

float quadratic(float x, float y) { return 1 + 2 * x - 3 * y + 0.5F * x * x - 4 * x * y + 3 * y * y; }

TEST(QuadraticFit, FindsTheDerivativesOfAQuadratic) {
  QuadraticFit fit(2);
  // 25 points, so that the last lanes are filled in part.
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const float x = 0.6F * static_cast<float>(i), y = 0.5F * static_cast<float>(j);
      fit.add(Vec3f(x, y, quadratic(x, y)));
    }
  // Points at the reach and beyond do not count.
  fit.add(Vec3f(0, 2, 1000));
  fit.add(Vec3f(-3, 0, 1000));
  const QuadraticFit::Terms terms = fit.solve(), exact{1, 2, -3, 1, -4, 6};
  for (Eigen::Index i = 0; i < terms.size(); ++i) EXPECT_NEAR(terms[i], exact[i], 2e-4) << "term " << i;
}

TEST(QuadraticFit, IsZeroWithoutAPointWithinItsReach) {
  QuadraticFit fit(1);
  fit.add(Vec3f(1, 1, 5));
  EXPECT_EQ(fit.solve(), QuadraticFit::Terms::Zero());
}

}  // namespace
}  // namespace burin
