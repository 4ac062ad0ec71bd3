#include <burin/math/elementary.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>

namespace burin {
namespace {

/// Greatest error in units in the last place of doubles over random numbers between `low` and `high`, against
/// the C library's function of more digits.
double worst_error(double low, double high, const std::function<double(double)>& ours,
                   const std::function<long double(long double)>& exact) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
    const long double expected = exact(x);
    const long double unit = std::ldexp(1.0L, std::max(std::ilogb(expected), -1022) - 52);
    worst = std::max(worst, static_cast<double>(std::abs((ours(x) - expected) / unit)));
  }
  return worst;
}

#define BURIN_OURS(f) [](double x) { return math::f(x); }
#define BURIN_EXACT(f) [](long double x) { return std::f(x); }

TEST(Elementary, SineCosineAndTangentAreExact) {
  for (const double most : {0.7, 10., 1000., 1e6}) {
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(sin), BURIN_EXACT(sin)), 1) << most;
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(cos), BURIN_EXACT(cos)), 1) << most;
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(tan), BURIN_EXACT(tan)), 4) << most;
  }
}

TEST(Elementary, ArcsAreExact) {
  for (const double most : {0.4, 1., 3., 1000.})
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(atan), BURIN_EXACT(atan)), 1) << most;
}

TEST(Elementary, AnglesOfAllDirectionsAreThoseOfTheCLibrary) {
  const double values[] = {
      0.0, -0.0, 1, -1, 2, -0.3, 1e-200, -1e200, std::numeric_limits<double>::infinity()};
  for (const double y : values)
    for (const double x : values) {
      const double expected = std::atan2(y, x), ours = math::atan2(y, x);
      EXPECT_NEAR(ours, expected, 1e-15) << y << " " << x;
      EXPECT_EQ(std::signbit(ours), std::signbit(expected)) << y << " " << x;
    }
  EXPECT_TRUE(std::isnan(math::atan2(std::nan(""), 1.0)));
}

TEST(Elementary, ExponentialsAndLogarithmsAreExact) {
  for (const double most : {0.3, 5., 700.}) {
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(exp), BURIN_EXACT(exp)), 1) << most;
    EXPECT_LT(worst_error(-most, most, BURIN_OURS(expm1), BURIN_EXACT(expm1)), 4) << most;
  }
  for (const double most : {1e-300, 0.5, 2., 1e300})
    EXPECT_LT(worst_error(0, most, BURIN_OURS(log), BURIN_EXACT(log)), 1) << most;
}

TEST(Elementary, PowersOfFloatsAreRoundedOnce) {
  for (float x = 0.001f; x < 2; x += 0.013f)
    for (float y = -3; y < 32; y += 0.37f)
      EXPECT_FLOAT_EQ(math::pow(x, y), static_cast<float>(std::pow(static_cast<long double>(x), y)));
}

TEST(Elementary, LengthsAreExact) {
  EXPECT_EQ(math::hypot(3.0, -4.0), 5.0);
  EXPECT_EQ(math::hypot(3e30f, 4e30f), 5e30f);  // whose squares no float can hold
  EXPECT_EQ(math::hypot(0.0f, -1e-40f), 1e-40f);
}

TEST(Elementary, EndsOfTheRangesAreThoseOfTheCLibrary) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(math::exp(infinity), infinity);
  EXPECT_EQ(math::exp(-infinity), 0);
  EXPECT_EQ(math::exp(1e9), infinity);
  EXPECT_EQ(math::exp(-1e9), 0);
  EXPECT_EQ(math::exp(-745.0), std::exp(-745.0));
  EXPECT_EQ(math::expm1(-infinity), -1);
  EXPECT_EQ(math::log(0.0), -infinity);
  EXPECT_EQ(math::log(infinity), infinity);
  EXPECT_EQ(math::pow(0.0f, 5.0f), 0);
  EXPECT_EQ(math::pow(0.0f, 0.0f), 1);
  EXPECT_EQ(math::pow(1.0f, 7.0f), 1);
  EXPECT_EQ(math::atan(infinity), std::atan(infinity));
  for (const double wrong : {std::nan(""), -1.0}) EXPECT_TRUE(std::isnan(math::log(wrong)));
  for (const double wrong : {std::nan(""), infinity}) {
    EXPECT_TRUE(std::isnan(math::sin(wrong)));
    EXPECT_TRUE(std::isnan(math::cos(wrong)));
    EXPECT_TRUE(std::isnan(math::tan(wrong)));
  }
  EXPECT_TRUE(std::isnan(math::exp(std::nan(""))));
  EXPECT_TRUE(std::isnan(math::atan(std::nan(""))));
}

/// Large angles keep the magnitude that the comment tells.
TEST(Elementary, LargeAnglesLoseDigitsInProportion) {
  EXPECT_NEAR(math::sin(1e9), std::sin(1e9), 1e9 * 0x1p-53);
  EXPECT_NEAR(math::cos(-1e12), std::cos(-1e12), 1e12 * 0x1p-53);
}

}  // namespace
}  // namespace burin
