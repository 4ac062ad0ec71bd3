#include <burin/base/error.h>
#include <burin/volume/solid.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/charted.h"
#include "support/error_of.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double stroke_radius = 0.2, rod_radius = 0.05, voxel = 0.01;

struct Ground {
  test::Charted charted{test::plane(1, 0.04, 7)};
  Chart chart;

  explicit Ground(double y = 0)
      : chart(charted.chart({.radius = stroke_radius},
                            test::sampled(30, [y](double s) { return Vec3d(s - 0.5, y, 0); }))) {}

  SolidGround ground() const {
    return {charted.surface, chart, [this](Index v) { return charted.surface.positions[v]; }};
  }

  StrokeSolid solid(const SolidExtent& extent, const DistanceToSolid& distance) const {
    return {ground(), extent, distance};
  }
  StrokeSolid rod() const { return solid(extent(), test::rod(chart, rod_radius, 0)); }

  static SolidExtent extent() {
    return {.h_min = -rod_radius, .h_max = rod_radius, .radius = stroke_radius, .voxel = voxel};
  }
};

/// Volume of the voxels whose middles are inside.
double volume_inside(const StrokeSolid& solid) {
  std::size_t inside = 0;
  for (const VoxelBlock& block : solid.blocks())
    inside +=
        static_cast<std::size_t>(std::ranges::count_if(block.values, [](float value) { return value < 0; }));
  return static_cast<double>(inside) * std::pow(solid.voxel(), 3);
}

TEST(StrokeSolid, TellsHowSteeplyADistanceChanges) {
  const Ground ground;
  for (const double size : {0.01, 0.012, 0.014, 0.016, 0.018, 0.02}) {
    SolidExtent extent = Ground::extent();
    extent.voxel = size;
    EXPECT_NEAR(median_slope(ground.solid(extent, test::rod(ground.chart, rod_radius, 0))), 1, 0.03) << size;
  }
  const DistanceToSolid rod = test::rod(ground.chart, rod_radius, 0);
  const auto flat = [&](std::span<const ShellPoint> points, std::span<float> distances) {
    rod(points, distances);
    for (float& distance : distances) distance *= 0.25F;
  };
  EXPECT_NEAR(median_slope(ground.solid(Ground::extent(), flat)), 0.25, 0.01);
  EXPECT_EQ(median_slope(StrokeSolid(voxel, {})), 1);
}

TEST(StrokeSolid, HoldsTheDistancesOfItsBand) {
  const Ground ground;
  const StrokeSolid solid = ground.rod();
  ASSERT_FALSE(solid.empty());
  std::size_t in_band = 0;
  for (const VoxelBlock& block : solid.blocks()) {
    for (int i = 0; i < VoxelBlock::voxels; ++i) {
      const Vec3d p = voxel * (block.origin + Eigen::Vector3i(i / 64, i / 8 % 8, i % 8)).cast<double>();
      const double beyond = p.x() - std::clamp(p.x(), -0.5, 0.5);
      const double distance = Vec3d(beyond, p.y(), p.z()).norm() - rod_radius, band = 3 * voxel;
      const auto value = static_cast<double>(block.values[static_cast<std::size_t>(i)]);
      EXPECT_NEAR(value, std::clamp(distance, -band, band), 1e-5) << p.transpose();
      if (std::abs(value) < band) ++in_band;
    }
  }
  EXPECT_GT(in_band, 10000u);
}

TEST(StrokeSolid, LeavesOutWhatIsFarFromIt) {
  const Ground ground;
  // A box of the whole shell would take ten times as many.
  const double blocks = static_cast<double>(ground.rod().blocks().size());
  EXPECT_LT(blocks * std::pow(8 * voxel, 3), 1.2 * 0.3 * 0.3);
}

TEST(StrokeSolid, IsCutOffAtTheStrokesRadius) {
  const Ground ground;
  const auto slab = [](std::span<const ShellPoint> points, std::span<float> distances) {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = std::abs(points[i].h) - 0.045F;
  };
  const double area = 1 * 2 * stroke_radius + std::numbers::pi * stroke_radius * stroke_radius;
  EXPECT_NEAR(volume_inside(ground.solid(Ground::extent(), slab)), 0.09 * area, 0.02 * 0.09 * area);
}

TEST(StrokeSolid, AddsAnother) {
  const Ground one, other(0.03);
  StrokeSolid both = one.rod();
  const StrokeSolid second = other.rod();
  both.add(second);
  EXPECT_GT(volume_inside(both), 1.2 * volume_inside(second));
  EXPECT_LT(volume_inside(both), 1.6 * volume_inside(second));
  EXPECT_TRUE(std::ranges::is_sorted(both.blocks(), [](const VoxelBlock& a, const VoxelBlock& b) {
    return std::ranges::lexicographical_compare(a.origin, b.origin);
  }));
  SolidExtent coarse = Ground::extent();
  coarse.voxel *= 2;
  EXPECT_THROW(both.add(one.solid(coarse, test::rod(one.chart, rod_radius, 0))), ContractError);
}

TEST(StrokeSolid, IsEmptyWhereTheDistanceIsNowhereNegative) {
  const Ground ground;
  const auto none = [](std::span<const ShellPoint>, std::span<float> distances) {
    std::ranges::fill(distances, 1.0F);
  };
  EXPECT_TRUE(ground.solid(Ground::extent(), none).empty());
}

TEST(StrokeSolid, RefusesWhatIsNone) {
  const Ground ground;
  const auto with = [&](auto change) {
    SolidExtent extent = Ground::extent();
    change(extent);
    return test::error_of([&] { ground.solid(extent, test::rod(ground.chart, rod_radius, 0)); });
  };
  EXPECT_EQ(with([](SolidExtent& e) { e.voxel = 0; }), "the voxel must be above 0");
  EXPECT_EQ(with([](SolidExtent& e) { e.voxel = std::numeric_limits<double>::quiet_NaN(); }),
            "the voxel must be above 0");
  EXPECT_EQ(with([](SolidExtent& e) { e.h_max = e.h_min; }), "a solid cannot reach from h -0.05 to -0.05");
  EXPECT_EQ(with([](SolidExtent& e) { e.voxel = 1e-12; }),
            "the voxel is too small for a surface of this extent");
  EXPECT_NE(with([](SolidExtent& e) { e.voxel = 1e-4; }).find("above the bound of 2147 MB"),
            std::string::npos);
  EXPECT_NE(with([](SolidExtent& e) { e.most_bytes = 100000; }).find("use larger voxels"), std::string::npos);
}

TEST(StrokeSolid, NamesWhereADistanceIsNotFinite) {
  const Ground ground;
  const auto broken = [](std::span<const ShellPoint> points, std::span<float> distances) {
    for (std::size_t i = 0; i < points.size(); ++i)
      distances[i] = points[i].t > 0.7 ? std::numeric_limits<float>::quiet_NaN() : 0.0F;
  };
  EXPECT_EQ(test::error_of([&] { ground.solid(Ground::extent(), broken); }).rfind("the distance at t 0.7", 0),
            0u);
}

}  // namespace
}  // namespace burin
