#include "deform_fixtures.h"

#include <burin/abi/stroke.h>
#include <burin/deform/stroke_nodes.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

/// A straight curve of length 1 drawn in 2 s with rising pressure and tilt.
SurfaceCurve curve() {
  SurfaceCurve curve;
  for (const float t : {0.0f, 0.5f, 1.0f}) {
    CurvePoint point{};
    point.at.position = Vec3f(t, 0.5f, 0);
    point.normal = Vec3f::UnitZ();
    point.tangent = Vec3f::UnitX();
    point.t = t;
    point.time = 2 * t;
    point.pen = {.pressure = t, .tilt_x = 0.5f * t};
    curve.points.push_back(point);
  }
  return curve;
}

TEST(StrokeNodes, HoldThePenAtTheirArcLength) {
  const Chart chart = test::straight_chart(test::square(101), 1, 0.1f);
  const StrokeNodes nodes =
      make_stroke_nodes(chart, curve(), 0.1, BURIN_INPUT_PRESSURE | BURIN_INPUT_TIME | BURIN_INPUT_SPEED);
  ASSERT_EQ(nodes.pen.size(), chart.size());
  ASSERT_GT(chart.size(), 1000u);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    EXPECT_NEAR(nodes.pen[i].pressure, chart.t[i], 1e-6);
    EXPECT_NEAR(nodes.pen[i].time, 2 * chart.t[i], 1e-6);
    EXPECT_NEAR(nodes.pen[i].speed, 0.5, 1e-6);
    EXPECT_EQ(nodes.pen[i].tilt_x, 0.0f) << "not asked for";
  }
}

TEST(StrokeNodes, HoldNoPenThatNobodyReads) {
  EXPECT_TRUE(make_stroke_nodes(test::straight_chart(test::square(5), 1, 1), curve(), 1, 0).pen.empty());
}

TEST(StrokeNodes, HoldTheHalfWidthAtTheirArcLength) {
  const Chart chart = test::straight_chart(test::square(101), 1, 0.1f);
  SurfaceCurve narrowing = curve();
  for (CurvePoint& point : narrowing.points) point.width = 1 - 0.5f * static_cast<float>(point.t);
  const StrokeNodes nodes = make_stroke_nodes(chart, narrowing, 0.2, BURIN_INPUT_RADIUS);
  ASSERT_EQ(nodes.half_width.size(), chart.size());
  EXPECT_TRUE(nodes.pen.empty());
  for (std::size_t i = 0; i < chart.size(); ++i)
    EXPECT_NEAR(nodes.half_width[i], 0.2 - 0.1 * chart.t[i], 1e-6);
  EXPECT_TRUE(make_stroke_nodes(chart, narrowing, 0.2, BURIN_INPUT_PRESSURE).half_width.empty());
}

TEST(StrokeNodes, TakeSpeedFromTime) {
  EXPECT_EQ(pen_inputs_present({}), 0u);
  EXPECT_EQ(pen_inputs_present({.time = true}), BURIN_INPUT_SPEED | BURIN_INPUT_TIME);
  EXPECT_EQ(pen_inputs_present({.pressure = true, .tilt = true, .twist = true}),
            BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT | BURIN_INPUT_TWIST);
}

}  // namespace
}  // namespace burin
