#include <burin/feature/best_path.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace burin::test {
namespace {

LevelImage image(int columns, int rows, const std::function<double(int column, int row)>& value) {
  LevelImage level{chart_grid(columns - 1, false, (rows - 1) / 2, 1, 0.1), {}};
  level.grid.margin = 0;
  level.grid.columns = columns;
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) level.values.push_back(static_cast<float>(value(column, row)));
  return level;
}

TEST(BestPath, IsTheBestOfAllThatGoByTwoRowsPerColumn) {
  // Columns with a false summit that a greedy path would follow.
  const LevelImage level = image(6, 5, [](int column, int row) {
    if (column < 3 && row == 4) return 1.1;
    return row == (column < 3 ? 1 : 0) ? 1. : 0.;
  });
  EXPECT_EQ(best_path(level, 0, 6, {.closeness = 0, .steepness = 0}), (std::vector{1, 1, 1, 0, 0, 0}));
  EXPECT_EQ(best_path(level, 0, 3, {.closeness = 0, .steepness = 0}), (std::vector{4, 4, 4}))
      << "some columns, in which the summit is the best";
  EXPECT_EQ(best_path(level, 0, 6, {.closeness = 0, .steepness = 4}), std::vector<int>(6, 4))
      << "steps that cost more than they gain";
}

TEST(BestPath, PrefersTheNearerOfTwoEqualCrests) {
  const LevelImage level = image(9, 21, [](int, int row) { return row == 3 || row == 14 ? 1. : 0.; });
  EXPECT_EQ(best_path(crest_score(level), 0, 9, {}), std::vector<int>(9, 14));
}

TEST(BestPath, CrossesWhatIsNotKnown) {
  const LevelImage level = image(12, 9, [](int column, int row) {
    if (column >= 5 && column < 8) return std::numeric_limits<double>::quiet_NaN();
    return row == 6 ? 1. : 0.;
  });
  EXPECT_EQ(best_path(crest_score(level), 0, 12, {}), std::vector<int>(12, 6));
}

TEST(BestPath, ScoresZeroCrossingsByTheirDistance) {
  const LevelImage level = image(5, 21, [](int, int row) { return 0.02 * (row - 7.25); });
  const LevelImage score = crossing_score(level, 4);
  EXPECT_NEAR(score.at(2, 7), 1 - 0.25 * 0.25 / 16, 1e-5);
  EXPECT_NEAR(score.at(2, 9), 1 - 1.75 * 1.75 / 16, 1e-5);
  EXPECT_EQ(score.at(2, 12), 0);
}

}  // namespace
}  // namespace burin::test
