#include <cmath>

#include "ink_brush.h"

namespace burin {
namespace {

class Arrow : public test::InkBrush {
 protected:
  Arrow() : InkBrush("brushes/arrow", "org.burin.arrow") {
    stroke_.params.set("tail", 0.5f);
    stroke_.params.set("shaft", 0.2f);
    stroke_.params.set("head_length", 2);
    stroke_.params.set("head_width", 0.9f);
  }

  /// The union of the paper's section 6 for an arrow of this length, drawn at this share of its size.
  static bool in_arrow(double t, double d, double length, double size = 1) {
    const double base = length - 2 * size;
    return std::hypot(t, d) < 0.5 * size || (t > 0 && t < base && std::abs(d) < 0.2 * size) ||
           (t > base && std::abs(d) < 0.9 * size * (length - t) / (2 * size));
  }
};

TEST_F(Arrow, IsTheUnionOfACircleARectangleAndATriangle) {
  expect_inside([](double t, double d) { return in_arrow(t, d, 10); });
}

TEST_F(Arrow, KeepsItsHeadAtTheEnd) {
  for (const double length : {2.5, 6.0, 9.0}) {
    stroke_.context.length = length;
    expect_inside([&](double t, double d) { return in_arrow(t, d, length); });
  }
  EXPECT_EQ(stroke_.plan.end_influence, 4) << "the head and what its base touches";
}

TEST_F(Arrow, IsSmallerWhereTheStrokeIsShort) {
  stroke_.context.length = 1.4;
  expect_inside([](double t, double d) { return in_arrow(t, d, 1.4, 0.7); });
  stroke_.context.length = 0;
  EXPECT_EQ(covered(0.1f, 0.1f), 1);
  EXPECT_EQ(covered(0.6f, 0), 0);
}

TEST_F(Arrow, BitesItsTailOnAClosedStroke) {
  stroke_.context.flags |= BURIN_STROKE_CLOSED;
  EXPECT_EQ(covered(9.9f, 0.4f), 1) << "the tail's circle, round the seam";
  EXPECT_EQ(covered(0.1f, 0.4f), 1);
  EXPECT_EQ(covered(8.2f, 0.7f), 1) << "the head";
  EXPECT_EQ(covered(5, 0.3f), 0);
}

TEST_F(Arrow, FillsADabFromRimToRim) {
  stroke_.context.flags |= BURIN_STROKE_DAB;
  stroke_.context.length = 0;
  EXPECT_EQ(covered(0.95f, 0), 1);
  EXPECT_EQ(covered(-0.95f, 0), 1);
  EXPECT_EQ(covered(0.9f, 0.5f), 0);
}

TEST_F(Arrow, RisesWithoutAValleyBetweenShaftAndHead) {
  stroke_.params.set("height", 0.3f);
  stroke_.params.set("bevel", 0.2f);
  test::Nodes line;
  for (float t = 1; t < 9.2f; t += 0.01f) line.t.push_back(t), line.d.push_back(0);
  covered(line);
  for (std::size_t i = 0; i < line.t.size(); ++i) EXPECT_FLOAT_EQ(stroke_.up[i], 0.3f) << line.t[i];
}

}  // namespace
}  // namespace burin
