#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace burin {
namespace {

/// Counts the floats of a range for which an array function rounds differently from the same function of
/// single floats.
template <typename Ours, typename Exact>
int differing(Ours ours, Exact exact) {
  int count = 0;
  for (int i = 0; i < 10000; ++i) {
    Eigen::Array<float, 16, 1> x;
    for (int lane = 0; lane < 16; ++lane) x[lane] = 1e-3f * static_cast<float>(16 * i + lane + 1);
    const Eigen::Array<float, 16, 1> y = ours(x);
    for (int lane = 0; lane < 16; ++lane) count += y[lane] != exact(x[lane]);
  }
  return count;
}

TEST(Eigen, RoundsSquareRootsAndInversesOfArraysRightly) {
  EXPECT_EQ(differing([](const auto& x) { return x.sqrt(); }, [](float x) { return std::sqrt(x); }), 0);
  EXPECT_EQ(differing([](const auto& x) { return x.rsqrt(); }, [](float x) { return 1 / std::sqrt(x); }), 0);
  EXPECT_EQ(differing([](const auto& x) { return x.inverse(); }, [](float x) { return 1 / x; }), 0);
}

}  // namespace
}  // namespace burin
