#include <cmath>

#include "ink_brush.h"

namespace burin {
namespace {

enum Align { start, middle, end_of_stroke, repeat };

/// The word "LL" of the test host's letters, 1.2 ems long at an em of 1.2.
class Text : public test::InkBrush {
 protected:
  Text() : InkBrush("brushes/text", "org.burin.text") {
    stroke_.params.set_file("text", "LL");
    stroke_.params.set("size", em);
    stroke_.params.set("baseline", 0);
  }

  /// Whether (t, d) lies in a word that starts at t = from; the font's ascent and descent centre it.
  static bool in_word(double t, double d, double from) {
    const double y = d / em + (test::TestHost::ascent - test::TestHost::descent) / 2;
    const double x = (t - from) / em;
    return test::TestHost::letter(x, y) > 0 || test::TestHost::letter(x - 0.6, y) > 0;
  }

  static constexpr float em = 1.2f;
  static constexpr double width = 1.2 * 1.2;
};

TEST_F(Text, RunsAlongTheStrokeItsTopToTheLeft) {
  expect_inside([](double t, double d) { return in_word(t, d, 0); });
  EXPECT_EQ(stroke_.plan.end_influence, 0);
}

TEST_F(Text, StandsInTheMiddleOrAtTheEnd) {
  stroke_.params.set("align", middle);
  expect_inside([](double t, double d) { return in_word(t, d, 5 - width / 2); });
  stroke_.params.set("align", end_of_stroke);
  expect_inside([](double t, double d) { return in_word(t, d, 10 - width); });
}

TEST_F(Text, FillsTheStrokeFromEndToEndWhenRepeated) {
  stroke_.params.set("align", repeat);
  stroke_.params.set("spacing", 0.5f);  // (10 + 0.5) / (1.44 + 0.5): five words
  expect_inside([](double t, double d) {
    for (int i = 0; i < 5; ++i)
      if (in_word(t, d, i * (10 - width) / 4)) return true;
    return false;
  });
}

TEST_F(Text, IsEvenlyRepeatedAroundALoop) {
  stroke_.params.set("align", repeat);
  stroke_.params.set("spacing", 0.5f);  // 10 / 1.94: five words, 2 apart
  stroke_.context.flags |= BURIN_STROKE_CLOSED;
  int inside = 0;
  for (float t = 0.013f; t < 2; t += 0.05f)
    for (int turn = 1; turn < 5; ++turn) {
      EXPECT_EQ(covered(t, 0.1f), covered(t + 2 * static_cast<float>(turn), 0.1f)) << t;
      inside += covered(t, 0.1f) > 0;
    }
  EXPECT_GT(inside, 10);
  stroke_.params.set("align", start);
  EXPECT_EQ(covered(0.1f, 0), 1);
  EXPECT_EQ(covered(2.1f, 0), 0) << "one word";
}

TEST_F(Text, CanBeReadOnAMirrorImageOfTheStroke) {
  // Seen from outside the frame (t, d) is left-handed there, so what is to be read runs against t.
  stroke_.context.flags |= BURIN_STROKE_MIRRORED;
  expect_inside([](double t, double d) { return in_word(width - t, d, 0); });
}

TEST_F(Text, MovesByItsBaseline) {
  stroke_.params.set("baseline", 0.2f);
  expect_inside([](double t, double d) { return in_word(t, d - 0.2, 0); });
}

TEST_F(Text, IsLowerWhereTheStrokeIsNarrow) {
  test::Nodes nodes{{0.1f, 0.1f}, {0.3f, 0.15f}};
  EXPECT_EQ(covered(nodes), (std::vector<float>{1, 1}));
  nodes.radius = 0.5f;
  EXPECT_EQ(covered(nodes), (std::vector<float>{0, 1}));
}

TEST_F(Text, FadesAtTheRim) {
  stroke_.params.set("size", 6);
  EXPECT_EQ(covered(0.4f, 0.8f), 1);
  EXPECT_LT(covered(0.4f, 0.99f), 0.1f);
  EXPECT_EQ(covered(0.4f, 1), 0);
}

TEST_F(Text, SaysWhatIsMissing) {
  stroke_.params.set_file("font", "NoSuchFont.ttf");
  EXPECT_EQ(stroke_.begin().text, "no font 'NoSuchFont.ttf'");
  stroke_.params.set_file("font", "DejaVuSans.ttf");
  stroke_.params.set_file("text", "");
  EXPECT_EQ(stroke_.begin().text, "there is nothing to write: parameter 'text' is empty");
  stroke_.params.set_file("text", "L");
  host_.withholds_services = true;
  EXPECT_EQ(stroke_.begin().status, BURIN_UNSUPPORTED);
  EXPECT_EQ(host_.open_stamps, 0);
}

TEST_F(Text, HasAPlaceOnADabAndWhereThePenHasNotMoved) {
  stroke_.context.length = 0;
  EXPECT_EQ(covered(0.1f, 0), 1);
  stroke_.context.flags |= BURIN_STROKE_DAB;
  EXPECT_EQ(covered(static_cast<float>(-width / 2) + 0.1f, 0), 1) << "around its middle";
}

}  // namespace
}  // namespace burin
