#include <burin/chart/box_grid.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "chart/uniform.h"

namespace burin {
namespace {

using test::uniform;

TEST(BoxGrid, NamesEveryBoxThatHoldsAPlace) {
  const std::uint32_t seed = 91;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const double largest : {0.02, 0.5, 0.}) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (int i = 0; i < 500; ++i) {
      const Vec2d from(10 * uniform(random), uniform(random));
      boxes.emplace_back(from, from + largest * Vec2d(uniform(random), uniform(random)));
    }
    const BoxGrid grid(boxes);
    std::size_t held = 0, looked_at = 0;
    const auto expect_named = [&](const Vec2d& place) {
      const auto near = grid.around(place);
      EXPECT_TRUE(std::ranges::is_sorted(near));
      looked_at += near.size();
      for (Index i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].contains(place)) continue;
        EXPECT_TRUE(std::ranges::binary_search(near, i));
        ++held;
      }
    };
    for (const auto& box : boxes) {
      expect_named(box.min());
      expect_named(box.max());
      expect_named(box.center());
    }
    EXPECT_GE(held, 1500U);
    EXPECT_LE(looked_at, 20 * held);
  }
}

TEST(BoxGrid, HasNothingAroundPlacesOfAnEmptyPlane) { EXPECT_TRUE(BoxGrid().around({1, -1e30}).empty()); }

TEST(BoxGrid, StandsPlacesFarOutside) {
  const std::vector<Eigen::AlignedBox2d> boxes = {{Vec2d(0, 0), Vec2d(1, 1)}, {Vec2d(2, 2), Vec2d(3, 3)}};
  const BoxGrid grid(boxes);
  EXPECT_LE(grid.around({1e300, -1e300}).size(), 2U);
}

}  // namespace
}  // namespace burin
