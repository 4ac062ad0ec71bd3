#include <burin/plugin/falloff.h>
#include <burin/plugin/stroke.h>
#include <gtest/gtest.h>

#include <limits>

namespace burin {
namespace {

using plugin::Stroke;

Stroke stroke(double length, std::uint64_t flags = 0) {
  burin_stroke_context context{};
  context.struct_size = sizeof context;
  context.length = length;
  context.flags = flags;
  return Stroke(context);
}

TEST(Stroke, KnowsTheWayBeyondItsEnds) {
  EXPECT_EQ(stroke(10).beyond(-3), -3);
  EXPECT_EQ(stroke(10).beyond(4), 0);
  EXPECT_EQ(stroke(10).beyond(13), 3);
  EXPECT_EQ(stroke(10).distance(13, -4), 5);
  EXPECT_EQ(stroke(10).distance(5, -4), 4);
  EXPECT_EQ(stroke(10, BURIN_STROKE_CLOSED).beyond(13), 0);
  EXPECT_EQ(stroke(10, BURIN_STROKE_CLOSED).distance(-3, -4), 4);
  EXPECT_EQ(stroke(0, BURIN_STROKE_DAB).distance(3, 4), 5);
  EXPECT_EQ(stroke(0, BURIN_STROKE_DAB).beyond(-3), -3);
}

TEST(Stroke, KnowsHowFarItIsPastItsEnds) {
  EXPECT_EQ(stroke(10).past_ends(-3), 3);
  EXPECT_EQ(stroke(10).past_ends(13), 3);
  EXPECT_EQ(stroke(10).past_ends(4), -4);
  EXPECT_EQ(stroke(10).past_ends(8), -2);
  for (const std::uint64_t endless : {BURIN_STROKE_CLOSED, BURIN_STROKE_DAB})
    EXPECT_EQ(stroke(10, endless).past_ends(13), -std::numeric_limits<float>::infinity());
}

TEST(Stroke, HasMarksAtEqualDistances) {
  EXPECT_EQ(stroke(10).from_mark(3.5F, 3), 0.5F);
  EXPECT_EQ(stroke(10).from_mark(2.5F, 3), -0.5F);
  EXPECT_EQ(stroke(10).from_mark(-4, 3), -4);
  EXPECT_EQ(stroke(10).from_mark(12, 3), 3);
  EXPECT_EQ(stroke(9, BURIN_STROKE_CLOSED).from_mark(-2.5F, 3), 0.5F);
}

TEST(Stroke, FitsPeriodsIntoALoop) {
  EXPECT_EQ(stroke(10).whole_period(3), 3);
  EXPECT_EQ(stroke(10, BURIN_STROKE_CLOSED).whole_period(3), 10.0 / 3);
  EXPECT_EQ(stroke(10, BURIN_STROKE_CLOSED).whole_period(2.6), 2.5);
  EXPECT_EQ(stroke(10, BURIN_STROKE_CLOSED).whole_period(99), 10);
  EXPECT_EQ(stroke(0, BURIN_STROKE_CLOSED).whole_period(3), 3);
}

TEST(Falloff, EndsAtRimAndEnds) {
  EXPECT_EQ(plugin::rim_factor(stroke(10), 5, 1, 2, 0.5f), 1);
  EXPECT_EQ(plugin::rim_factor(stroke(10), 5, -1.5f, 2, 0.5f), 0.5f);
  EXPECT_EQ(plugin::rim_factor(stroke(10), 11.5f, 1.6f, 2, 0.5f), 0);
  EXPECT_EQ(plugin::taper_factor(stroke(10), 0, 2, 1), 0);
  EXPECT_EQ(plugin::taper_factor(stroke(10), 1, 2, 1), 0.5f);
  EXPECT_EQ(plugin::taper_factor(stroke(10), 2, 2, 1), 1);
  EXPECT_EQ(plugin::taper_factor(stroke(10), 1, 2, 0), 1);
  EXPECT_EQ(plugin::taper_factor(stroke(10, BURIN_STROKE_CLOSED), 0, 2, 1), 1);
  EXPECT_EQ(plugin::taper_factor(stroke(0, BURIN_STROKE_DAB), 0, 2, 1), 1);
}

TEST(Falloff, HardlyTapersWhatIsShorterThanARadius) {
  EXPECT_EQ(plugin::taper_factor(stroke(0), 0, 2, 1), 1) << "a tap";
  EXPECT_EQ(plugin::taper_factor(stroke(0.5), 0, 2, 1), 0.75f);
  EXPECT_EQ(plugin::taper_factor(stroke(2), 0, 2, 1), 0);
}

TEST(Falloff, TellsHowFarATaperReaches) {
  const double radius = stroke(10).radius_max();
  EXPECT_EQ(plugin::taper_influence(stroke(10), 3), 3 * radius);
  EXPECT_EQ(plugin::taper_influence(stroke(10), 0.5f), 2 * radius)
      << "all of a stroke as short as its radius";
  EXPECT_EQ(plugin::taper_influence(stroke(10), 0), 0);
}

TEST(Falloff, RoundsStrands) {
  EXPECT_EQ(plugin::strand_profile(0), 1);
  EXPECT_FLOAT_EQ(plugin::strand_profile(0.6f), 0.8f);
  EXPECT_NEAR(plugin::strand_profile(0.9001f), plugin::strand_profile(0.8999f), 1e-3f);
  EXPECT_NEAR(plugin::strand_profile(1.9f) - plugin::strand_profile(0.9f), -0.9 / std::sqrt(0.19), 1e-5)
      << "the tangent";
}

}  // namespace
}  // namespace burin
