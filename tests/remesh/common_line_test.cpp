#include <burin/remesh/common_line.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace burin {
namespace {

std::vector<Vec3d> circle(int points, double radius, double from = 0, bool turned = false) {
  std::vector<Vec3d> line;
  for (int i = 0; i < points; ++i) {
    const double angle = (turned ? -1 : 1) * 2 * std::numbers::pi * i / points + from;
    line.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return line;
}

TEST(CommonLine, OrdersTheVerticesOfBoth) {
  const std::vector<Vec3d> first = circle(40, 1), second = circle(27, 1.01, 2);
  const auto order = along_common_line(first, second, 0.05);
  ASSERT_TRUE(order);
  ASSERT_EQ(order->size(), 67u);
  double last = -1;
  std::vector<int> seen(67, 0);
  for (std::size_t i = 0; i < order->size(); ++i) {
    const OnLine& at = (*order)[i];
    ++seen[at.of_first ? at.number : 40 + at.number];
    const Vec3d& p = at.of_first ? first[at.number] : second[at.number];
    // From the second's first vertex on.
    double angle = std::atan2(p.y(), p.x()) - 2;
    while (angle < -1e-6) angle += 2 * std::numbers::pi;
    EXPECT_GE(angle, last - 1e-3) << i;
    last = angle;
  }
  EXPECT_EQ(seen, std::vector<int>(67, 1));
}

TEST(CommonLine, IsNoneWhereOneStraysTurnsBackOrRunsAgainstTheOther) {
  EXPECT_FALSE(along_common_line(circle(40, 1), circle(27, 1.2), 0.1));
  EXPECT_FALSE(along_common_line(circle(40, 1), circle(27, 1, 0, true), 0.1));
  std::vector<Vec3d> half = circle(40, 1);
  half.resize(15);
  EXPECT_FALSE(along_common_line(circle(40, 1), half, 0.1));
}

TEST(PairLines, FindsEachLoopsPartner) {
  const auto patch_of = [](const std::vector<std::vector<Vec3d>>& lines, std::vector<Loop>& loops) {
    PatchMesh patch;
    for (const auto& line : lines) {
      Loop& loop = loops.emplace_back();
      for (const Vec3d& p : line) {
        loop.push_back(patch.vertex_count());
        patch.positions.push_back(p);
      }
    }
    patch.kept.assign(patch.positions.size(), no_index);
    return patch;
  };
  std::vector<Loop> loops, others;
  const PatchMesh first = patch_of({circle(40, 1), circle(20, 0.5), circle(9, 0.1)}, loops);
  const PatchMesh second = patch_of({circle(30, 0.5, 1, true), circle(50, 1, 2, true)}, others);
  const std::vector<LinePair> pairs = pair_lines(first, loops, second, others, 0.05);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].first, 1u);
  EXPECT_EQ(pairs[0].second, 0u);
  EXPECT_EQ(pairs[1].first, 0u);
  EXPECT_EQ(pairs[1].second, 1u);
  EXPECT_EQ(pairs[1].turned.front(), others[1].back());
  EXPECT_EQ(pairs[1].order.size(), 90u);
}

}  // namespace
}  // namespace burin
