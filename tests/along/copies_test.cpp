#include <burin/along/copies.h>
#include <burin/base/error.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace burin {
namespace {

using Part = CopyPlace::Part;

std::vector<CopyPlace> laid(const CopyLengths& lengths) { return lay_copies(lengths, 1e6); }

void expect_place(const CopyPlace& place, Part part, double begin, double end) {
  EXPECT_EQ(place.part, part);
  EXPECT_DOUBLE_EQ(place.begin, begin);
  EXPECT_DOUBLE_EQ(place.end, end);
}

TEST(Copies, FillTheStroke) {
  const auto places = laid({.middle = 0.3, .stroke = 1});
  ASSERT_EQ(places.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    expect_place(places[i], Part::middle, static_cast<double>(i) / 3, static_cast<double>(i + 1) / 3);
  EXPECT_EQ(places[0].end, places[1].begin);
  EXPECT_EQ(places[2].end, 1);
  ASSERT_EQ(laid({.middle = 3, .stroke = 1}).size(), 1u);
  expect_place(laid({.middle = 3, .stroke = 1})[0], Part::middle, 0, 1);
  EXPECT_TRUE(laid({.middle = 3, .stroke = 0}).empty());
}

TEST(Copies, LieBetweenStartAndEnd) {
  const auto places = laid({.start = 0.2, .middle = 0.25, .end = 0.3, .stroke = 1});
  ASSERT_EQ(places.size(), 4u);
  expect_place(places[0], Part::start, 0, 0.2);
  expect_place(places[1], Part::middle, 0.2, 0.45);
  EXPECT_EQ(places[1].end, places[2].begin);
  expect_place(places[3], Part::end, 0.7, 1);
  EXPECT_EQ(places[2].end, places[3].begin);
}

TEST(Copies, LeaveTheStrokeToStartAndEndWhereNoneFits) {
  const auto both = laid({.start = 1, .middle = 0.3, .end = 3, .stroke = 1});
  ASSERT_EQ(both.size(), 2u);
  expect_place(both[0], Part::start, 0, 0.25);
  expect_place(both[1], Part::end, 0.25, 1);
  const auto start = laid({.start = 0.9, .middle = 0.3, .stroke = 1});
  ASSERT_EQ(start.size(), 1u);
  expect_place(start[0], Part::start, 0, 1);
  const auto end = laid({.middle = 0.3, .end = 2, .stroke = 1});
  ASSERT_EQ(end.size(), 1u);
  expect_place(end[0], Part::end, 0, 1);
}

TEST(Copies, StandApartAsTold) {
  const auto places = laid({.start = 0.1, .middle = 0.2, .stroke = 1, .spacing = 0.35});
  ASSERT_EQ(places.size(), 4u);
  expect_place(places[1], Part::middle, 0.1, 0.3);
  expect_place(places[2], Part::middle, 0.45, 0.65);
  expect_place(places[3], Part::middle, 0.8, 1);
  const auto pressed = laid({.middle = 2, .stroke = 1, .spacing = 0.1});
  ASSERT_EQ(pressed.size(), 1u);
  expect_place(pressed[0], Part::middle, 0, 1);
}

TEST(Copies, GoAroundClosedStrokesInWholeNumbers) {
  const auto full = laid({.middle = 0.3, .stroke = 1, .closed = true});
  ASSERT_EQ(full.size(), 3u);
  EXPECT_EQ(full[0].begin, 0);
  EXPECT_EQ(full[2].end, 1);
  const auto apart = laid({.middle = 0.1, .stroke = 1, .spacing = 0.24, .closed = true});
  ASSERT_EQ(apart.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    expect_place(apart[i], Part::middle, 0.25 * static_cast<double>(i),
                 0.25 * static_cast<double>(i) + 0.1 * 0.25 / 0.24);
}

TEST(Copies, AreNotTooMany) {
  EXPECT_THROW(laid({.middle = 1e-9, .stroke = 1}), Error);
  EXPECT_THROW(laid({.middle = 0.1, .stroke = 1, .spacing = 1e-9}), Error);
  EXPECT_THROW(laid({.middle = 0.1, .stroke = 1, .spacing = 1e-9, .closed = true}), Error);
}

}  // namespace
}  // namespace burin
