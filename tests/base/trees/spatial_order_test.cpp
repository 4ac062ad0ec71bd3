#include <burin/base/trees/spatial_order.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace burin {
namespace {

// Consecutive cells of a Hilbert curve share a face, and the curve visits each cell once.
TEST(SpatialOrder, WalksAGridInUnitSteps) {
  std::vector<Vec3f> points;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) points.emplace_back(x, y, z);
  std::ranges::reverse(points);
  const std::vector<Index> order = spatial_order(points);
  ASSERT_EQ(order.size(), points.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    ASSERT_EQ((points[order[i]] - points[order[i - 1]]).lpNorm<1>(), 1) << "step " << i;
}

TEST(SpatialOrder, OrdersEqualPointsByIndex) {
  EXPECT_EQ(spatial_order(std::vector<Vec3f>(5, Vec3f(1, 2, 3))), (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(spatial_order({}).empty());
}

}  // namespace
}  // namespace burin
