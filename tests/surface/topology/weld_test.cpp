#include <burin/surface/topology/weld.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

TEST(FirstAtPlace, IsTheLowestIndexOfAPlace) {
  const std::vector<Vec3f> points = {{1, 2, 3},         {0, 0, 0}, {1, 2, 3},
                                     {-0.0f, 0, -0.0f}, {1, 2, 4}, {1, 2, 3}};
  EXPECT_EQ(first_at_position(points), (std::vector<Index>{0, 1, 0, 1, 4, 0}));
  EXPECT_TRUE(first_at_position({}).empty());
}

TEST(FirstAtPlace, OrdersNotANumberToo) {
  std::vector<Vec3f> points(1000, Vec3f(NAN, 1, 1));
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] = Vec3f(1, 1, static_cast<float>(i % 10));
  const std::vector<Index> first = first_at_position(points);
  for (Index i = 0; i < points.size(); ++i) EXPECT_EQ(first[i], i % 2 ? 1 : i % 10);
}

}  // namespace
}  // namespace burin
