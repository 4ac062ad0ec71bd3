#include <burin/volume/voxel_field.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>

namespace burin {
namespace {

constexpr double pi = std::numbers::pi;

/// A field whose voxels have these values.
template <class Value>
VoxelField field(VoxelField::Kind kind, const Eigen::Vector3i& size, double unit, const Value& value) {
  return {kind, size, unit, [&](const Eigen::Vector3i& first, std::array<float, 512>& values) {
            for (int i = 0; i < 512; ++i)
              values[static_cast<std::size_t>(i)] =
                  static_cast<float>(value(first.x() + i / 64, first.y() + i / 8 % 8, first.z() + i % 8));
          }};
}

TEST(VoxelField, HasTheValuesOfVoxelsAtTheirMiddles) {
  const auto value = [](int i, int j, int k) { return i + 100 * j + 10000 * k; };
  const VoxelField numbers = field(VoxelField::Kind::fog, {19, 9, 8}, 1, value);
  for (int i = 0; i < 19; ++i)
    for (int j = 0; j < 9; ++j)
      for (int k = 0; k < 8; ++k)
        ASSERT_EQ(numbers.at({i + 0.5, j + 0.5, k + 0.5}, {}), static_cast<float>(value(i, j, k)));
  EXPECT_EQ(numbers.minimum(), 0);
  EXPECT_EQ(numbers.maximum(), 18 + 800 + 70000) << "of the box alone";
  EXPECT_FLOAT_EQ(numbers.at({4.75, 3.5, 2.5}, {}), 4.25F + 300 + 20000) << "linear between";
}

TEST(VoxelField, TellsDistancesInVoxels) {
  // The plane x = 3 voxels, told in a unit in which a voxel is 0.1 long.
  const VoxelField plane =
      field(VoxelField::Kind::level_set, {8, 4, 4}, 0.1, [](int i, int, int) { return 0.1 * (i + 0.5 - 3); });
  EXPECT_NEAR(plane.at({5, 2, 2}, {}), 2, 1e-6);
  EXPECT_NEAR(plane.minimum(), -2.5, 1e-6);
}

TEST(VoxelField, RepeatsWithoutASeam) {
  constexpr int period = 12;
  const auto wave = [](double x) { return 3 * std::sin(2 * pi * (x + 0.5) / period); };
  const VoxelField waves =
      field(VoxelField::Kind::level_set, {period, 3, 3}, 1, [&](int i, int, int) { return wave(i); });
  double worst = 0, across_seam = 0;
  for (int i = -3000; i < 3000; ++i) {
    const double x = i / 100.0;
    const double from_middle = x - 0.5, lower = std::floor(from_middle), share = from_middle - lower;
    const double exact = (1 - share) * wave(lower) + share * wave(lower + 1);
    worst = std::max(worst, std::abs(static_cast<double>(waves.at({x, 1.5, 1.5}, {true})) - exact));
  }
  for (const double e : {1e-9, 1e-7, 1e-5}) {
    const float before = waves.at({period - e, 1.5, 1.5}, {true}), after = waves.at({e, 1.5, 1.5}, {true});
    across_seam = std::max(across_seam, std::abs(static_cast<double>(before - after)));
  }
  std::cout << "off by " << worst << " voxels, across the seam by " << across_seam << '\n';
  EXPECT_LT(worst, 2e-6);
  EXPECT_LT(across_seam, 1e-3);
}

TEST(VoxelField, IsEmptyBeyondItsBox) {
  const Vec3d middle(6, 6, 6);
  const auto ball = [&](const Vec3d& p) { return std::min((p - middle).norm() - 3, 2.0); };
  const VoxelField solid = field(VoxelField::Kind::level_set, {12, 12, 12}, 1,
                                 [&](int i, int j, int k) { return ball(Vec3d(i + 0.5, j + 0.5, k + 0.5)); });
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-20, 32);
  int beyond = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3d p(anywhere(random), anywhere(random), anywhere(random));
    const double bound = static_cast<double>(solid.at(p, {})), exact = (p - middle).norm() - 3;
    if (p.minCoeff() >= 0.5 && p.maxCoeff() <= 11.5) continue;
    ++beyond;
    EXPECT_LE(bound, exact + 0.1);
    EXPECT_GT(bound, 0.2 * exact) << p.transpose();
  }
  EXPECT_GT(beyond, 9000);
  const VoxelField fog = field(VoxelField::Kind::fog, {4, 4, 4}, 1, [](int, int, int) { return 1; });
  EXPECT_EQ(fog.at({2, 2, 2}, {}), 1);
  EXPECT_EQ(fog.at({2, 2, 4.5}, {}), 0);
  EXPECT_EQ(fog.at({1000.25, 2, 2}, {true}), 1);
  EXPECT_TRUE(std::isnan(fog.at({std::numeric_limits<double>::infinity(), 2, 2}, {true})));
}

TEST(VoxelField, MayBeOneVoxelWide) {
  const VoxelField one = field(VoxelField::Kind::fog, {1, 1, 1}, 1, [](int, int, int) { return 7; });
  EXPECT_EQ(one.at({0.5, 0.5, 0.5}, {}), 7);
  EXPECT_EQ(one.at({-3.1, 99, 0.2}, {true, true, true}), 7);
}

}  // namespace
}  // namespace burin
