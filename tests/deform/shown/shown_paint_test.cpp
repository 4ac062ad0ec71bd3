#include <burin/abi/stroke.h>
#include <burin/deform/shown/shown_paint.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

const Vec4f red(1, 0, 0, 1);

class ShownPaintTest : public ::testing::Test {
 protected:
  ShownPaintTest() { paint_.prepare(BURIN_OUTPUT_COLOUR | BURIN_OUTPUT_MASK); }

  std::vector<Index> set(const std::vector<Index>& vertices, const std::vector<Tint>& tints) {
    std::vector<Index> changed;
    paint_.set(vertices, tints, changed);
    return changed;
  }

  ShownPaint paint_{4};
};

TEST_F(ShownPaintTest, IsBareUntilPainted) {
  EXPECT_EQ(paint_.shown().colour, std::vector<Vec4f>(4, Paint::bare()));
  EXPECT_EQ(paint_.shown().mask, std::vector<float>(4, 1));
  ShownPaint untouched(3);
  untouched.prepare(BURIN_OUTPUT_DISPLACEMENT);
  EXPECT_TRUE(untouched.shown().colour.empty() && untouched.shown().mask.empty());
  EXPECT_EQ(untouched.shown().colour_of(2), Paint::bare());
  EXPECT_EQ(untouched.shown().mask_of(2), 1);
}

TEST_F(ShownPaintTest, ReportsWhatLooksOtherThanBefore) {
  const Tint bare = tint_of(Paint::bare(), 1);
  EXPECT_EQ(set({1, 2}, {tint_of(red, 1), bare}), (std::vector<Index>{1}));
  EXPECT_EQ(set({1, 3}, {tint_of(red, 1), tint_of(Paint::bare(), 0.5f)}), (std::vector<Index>{3}));
  EXPECT_EQ(set({1}, {bare}), (std::vector<Index>{1})) << "back to its base";
}

TEST_F(ShownPaintTest, CommitsAndGoesBackBitForBit) {
  const Vec4f odd(0.1f, 0.7f, 0.3f, 0.37f);  // whose premultiplied form does not divide back exactly
  Paint start;
  start.colour.assign(4, odd);
  start.mask.assign(4, 0.9f);
  paint_.assign(start);
  set({0, 1, 2}, {tint_of(odd, 0.9f), tint_of(red, 0.9f), tint_of(odd, 0.2f)});
  EXPECT_EQ(paint_.shown().colour[0], odd) << "the tint of the base gives its very bits";
  const PaintStep step = paint_.commit();
  EXPECT_EQ(step.vertices, (std::vector<Index>{1, 2}));
  EXPECT_EQ(paint_.base().colour[1], red);
  EXPECT_EQ(paint_.base().mask[2], 0.2f);
  paint_.restore(step);
  for (const Paint* paint : {&paint_.base(), &paint_.shown()}) {
    EXPECT_EQ(paint->colour, start.colour);
    EXPECT_EQ(paint->mask, start.mask);
  }
}

TEST_F(ShownPaintTest, GoesBackToPaintThatWasTakenAwaySince) {
  set({2}, {tint_of(red, 0.5f)});
  paint_.commit();
  set({2}, {tint_of(Paint::bare(), 1)});
  const PaintStep to_red = paint_.commit();
  paint_.assign({});
  paint_.restore(to_red);
  EXPECT_EQ(paint_.shown().colour[2], red);
  EXPECT_EQ(paint_.base().mask[2], 0.5f);
  EXPECT_EQ(paint_.shown().colour[1], Paint::bare());
}

TEST_F(ShownPaintTest, HasNoArraysOnceAllPaintingIsTakenBack) {
  const auto expect_empty = [&](bool colours, bool masks) {
    for (const Paint* paint : {&paint_.base(), &paint_.shown()}) {
      EXPECT_EQ(paint->colour.empty(), colours);
      EXPECT_EQ(paint->mask.empty(), masks);
    }
  };
  const std::uint64_t both = BURIN_OUTPUT_COLOUR | BURIN_OUTPUT_MASK;
  paint_.drop();
  expect_empty(true, true);
  paint_.prepare(both);
  set({1}, {tint_of(red, 1)});
  const PaintStep to_none = paint_.commit();
  expect_empty(false, true);
  const PaintStep to_red = paint_.restore(to_none);
  expect_empty(true, true);
  paint_.restore(to_red);
  EXPECT_EQ(paint_.base().colour, (std::vector<Vec4f>{Paint::bare(), red, Paint::bare(), Paint::bare()}));

  // Assigned beside masks, what was painted is still the stroke's.
  Paint with_masks = paint_.base();
  with_masks.mask.assign(4, 1);
  paint_.assign(with_masks);
  paint_.restore(to_none);
  expect_empty(true, false);
  paint_.restore(to_red);
  const Paint of_four = paint_.exchange(2, {{red, Paint::bare()}, {1, 1}});
  EXPECT_EQ(of_four.colour[1], red);
  paint_.exchange(4, of_four);
  paint_.restore(to_none);
  expect_empty(true, false);
  paint_.exchange(3, {});
  paint_.prepare(both);
  EXPECT_EQ(paint_.shown().colour, std::vector<Vec4f>(3, Paint::bare()));
  paint_.drop();
  expect_empty(true, false);

  paint_.assign({std::vector<Vec4f>(3, Paint::bare()), {}});
  expect_empty(false, true);
}

TEST_F(ShownPaintTest, DropsWhatWasNotCommitted) {
  set({0, 3}, {tint_of(red, 0), tint_of(red, 0.5f)});
  paint_.drop();
  EXPECT_EQ(paint_.shown().colour, paint_.base().colour);
  EXPECT_EQ(paint_.shown().mask, paint_.base().mask);
  EXPECT_TRUE(paint_.commit().vertices.empty());
}

TEST_F(ShownPaintTest, KeepsTheBitsOfColoursUnderAnotherMask) {
  const Vec4f odd(0.1f, 0.7f, 0.3f, 0.37f), hidden(0.2f, 0.4f, 0.6f, 0);
  Paint start;
  start.colour = {odd, hidden, red, red};
  paint_.assign(start);
  paint_.prepare(BURIN_OUTPUT_MASK);
  EXPECT_EQ(set({0, 1, 2}, {tint_of(odd, 0.5f), tint_of(hidden, 0), tint_of(red, 1)}),
            (std::vector<Index>{0, 1}));
  EXPECT_EQ(paint_.shown().colour, start.colour);
  EXPECT_EQ(paint_.shown().mask, (std::vector<float>{0.5f, 0, 1, 1}));
}

}  // namespace
}  // namespace burin
