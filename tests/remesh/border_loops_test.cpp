#include <burin/base/error.h>
#include <burin/remesh/border_loops.h>
#include <burin/remesh/divide.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

using test::same;

TEST(BorderSides, AreThoseOfOneTriangleAlone) {
  const PatchMesh patch = test::flat_patch(3);
  const auto sides = border_sides(patch.triangles);
  EXPECT_EQ(sides.size(), 12u);
  for (const auto& [side, triangle] : sides) {
    const Triangle& t = patch.triangles[triangle];
    const auto at = static_cast<std::size_t>(std::ranges::find(t, side.first) - t.begin());
    ASSERT_LT(at, 3u);
    EXPECT_EQ(t[(at + 1) % 3], side.second);
  }
}

TEST(BorderLoops, LeaveOutFixedSides) {
  EXPECT_TRUE(border_loops(test::flat_patch(3)).empty());
  const auto beyond_circle = [](const Vec3d& p) { return (p - Vec3d(4, 4, 0)).norm() - 2.3; };
  const PatchMesh ring = kept_part(divide(test::flat_patch(8), beyond_circle, same));
  const std::vector<Loop> loops = border_loops(ring);
  ASSERT_EQ(loops.size(), 1u);
  double area = 0;
  for (std::size_t i = 0; i < loops[0].size(); ++i) {
    const Vec3d &from = ring.positions[loops[0][i]],
                &to = ring.positions[loops[0][(i + 1) % loops[0].size()]];
    area += from.cross(to).z() / 2;
  }
  EXPECT_NEAR(area, -3.14159265 * 2.3 * 2.3, 0.4) << "the ring lies to the left";
}

TEST(BorderLoops, RefuseABorderThatTouchesItself) {
  const PatchMesh bow{{{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}},
                      {{0, 1, 2}, {0, 4, 3}},
                      std::vector<Index>(5, no_index)};
  EXPECT_THROW(border_loops(bow), Error);
}

}  // namespace
}  // namespace burin
