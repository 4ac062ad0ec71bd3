#include <burin/along/copies.h>
#include <burin/base/error.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace burin {
namespace {

using Part = CopyInterval::Part;

std::vector<CopyInterval> laid(const CopyLengths& lengths) { return lay_copies(lengths, 1e6); }

void expect_interval(const CopyInterval& interval, Part part, double begin, double end) {
  EXPECT_EQ(interval.part, part);
  EXPECT_DOUBLE_EQ(interval.begin, begin);
  EXPECT_DOUBLE_EQ(interval.end, end);
}

TEST(Copies, FillTheStroke) {
  const auto intervals = laid({.middle = 0.3, .stroke = 1});
  ASSERT_EQ(intervals.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    expect_interval(intervals[i], Part::middle, static_cast<double>(i) / 3, static_cast<double>(i + 1) / 3);
  EXPECT_EQ(intervals[0].end, intervals[1].begin);
  EXPECT_EQ(intervals[2].end, 1);
  ASSERT_EQ(laid({.middle = 3, .stroke = 1}).size(), 1u);
  expect_interval(laid({.middle = 3, .stroke = 1})[0], Part::middle, 0, 1);
  EXPECT_TRUE(laid({.middle = 3, .stroke = 0}).empty());
}

TEST(Copies, LieBetweenStartAndEnd) {
  const auto intervals = laid({.start = 0.2, .middle = 0.25, .end = 0.3, .stroke = 1});
  ASSERT_EQ(intervals.size(), 4u);
  expect_interval(intervals[0], Part::start, 0, 0.2);
  expect_interval(intervals[1], Part::middle, 0.2, 0.45);
  EXPECT_EQ(intervals[1].end, intervals[2].begin);
  expect_interval(intervals[3], Part::end, 0.7, 1);
  EXPECT_EQ(intervals[2].end, intervals[3].begin);
}

TEST(Copies, LeaveTheStrokeToStartAndEndWhereNoneFits) {
  const auto both = laid({.start = 1, .middle = 0.3, .end = 3, .stroke = 1});
  ASSERT_EQ(both.size(), 2u);
  expect_interval(both[0], Part::start, 0, 0.25);
  expect_interval(both[1], Part::end, 0.25, 1);
  const auto start = laid({.start = 0.9, .middle = 0.3, .stroke = 1});
  ASSERT_EQ(start.size(), 1u);
  expect_interval(start[0], Part::start, 0, 1);
  const auto end = laid({.middle = 0.3, .end = 2, .stroke = 1});
  ASSERT_EQ(end.size(), 1u);
  expect_interval(end[0], Part::end, 0, 1);
}

TEST(Copies, StandApartAsTold) {
  const auto intervals = laid({.start = 0.1, .middle = 0.2, .stroke = 1, .spacing = 0.35});
  ASSERT_EQ(intervals.size(), 4u);
  expect_interval(intervals[1], Part::middle, 0.1, 0.3);
  expect_interval(intervals[2], Part::middle, 0.45, 0.65);
  expect_interval(intervals[3], Part::middle, 0.8, 1);
  const auto pressed = laid({.middle = 2, .stroke = 1, .spacing = 0.1});
  ASSERT_EQ(pressed.size(), 1u);
  expect_interval(pressed[0], Part::middle, 0, 1);
}

TEST(Copies, GoAroundClosedStrokesInWholeNumbers) {
  const auto full = laid({.middle = 0.3, .stroke = 1, .closed = true});
  ASSERT_EQ(full.size(), 3u);
  EXPECT_EQ(full[0].begin, 0);
  EXPECT_EQ(full[2].end, 1);
  const auto apart = laid({.middle = 0.1, .stroke = 1, .spacing = 0.24, .closed = true});
  ASSERT_EQ(apart.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    expect_interval(apart[i], Part::middle, 0.25 * static_cast<double>(i),
                    0.25 * static_cast<double>(i) + 0.1 * 0.25 / 0.24);
}

TEST(Copies, AreNotTooMany) {
  EXPECT_THROW(laid({.middle = 1e-9, .stroke = 1}), Error);
  EXPECT_THROW(laid({.middle = 0.1, .stroke = 1, .spacing = 1e-9}), Error);
  EXPECT_THROW(laid({.middle = 0.1, .stroke = 1, .spacing = 1e-9, .closed = true}), Error);
}

}  // namespace
}  // namespace burin
