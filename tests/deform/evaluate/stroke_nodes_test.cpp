#include "deform/deform_fixtures.h"

#include <burin/abi/stroke.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace burin {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

ReadInputs reading(std::uint64_t inputs, double radius = 0.1) {
  constexpr std::uint64_t varying = BURIN_INPUT_RADIUS | BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT |
                                    BURIN_INPUT_TWIST | BURIN_INPUT_SPEED | BURIN_INPUT_TIME;
  return {radius, inputs, inputs & varying};
}

TEST(StrokeNodes, HoldThePenAtTheirArcLength) {
  const Surface surface = test::square(101);
  const Chart chart = test::straight_chart(surface, 1, 0.1f);
  const test::DrawnNodes drawn(surface, chart,
                               reading(BURIN_INPUT_PRESSURE | BURIN_INPUT_TIME | BURIN_INPUT_SPEED));
  ASSERT_EQ(drawn.nodes.pen().size(), chart.size());
  ASSERT_GT(chart.size(), 1000u);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const NodePen& pen = drawn.nodes.pen()[i];
    EXPECT_NEAR(pen.pressure, chart.t[i], 1e-6);
    EXPECT_NEAR(pen.time, 2 * chart.t[i], 1e-6);
    EXPECT_NEAR(pen.speed, 0.5, 1e-6);
    EXPECT_EQ(pen.tilt_x, 0.0f) << "not asked for";
  }
}

TEST(StrokeNodes, HoldNoPenThatNobodyReads) {
  const Surface surface = test::square(5);
  const test::DrawnNodes drawn(surface, test::straight_chart(surface, 1, 1), reading(BURIN_INPUT_T));
  EXPECT_TRUE(drawn.nodes.pen().empty());
  EXPECT_TRUE(drawn.nodes.half_width().empty());
}

TEST(StrokeNodes, HoldTheHalfWidthAtTheirArcLength) {
  const Surface surface = test::square(101);
  const Chart chart = test::straight_chart(surface, 1, 0.1f);
  SurfaceCurve narrowing = test::straight_curve();
  for (CurvePoint& point : narrowing.points) point.width = 1 - 0.5f * static_cast<float>(point.t);
  const test::DrawnNodes drawn(surface, chart, reading(BURIN_INPUT_RADIUS, 0.2), narrowing);
  ASSERT_EQ(drawn.nodes.half_width().size(), chart.size());
  EXPECT_TRUE(drawn.nodes.pen().empty());
  for (std::size_t i = 0; i < chart.size(); ++i)
    EXPECT_NEAR(drawn.nodes.half_width()[i], 0.2 - 0.1 * chart.t[i], 1e-6);
}

TEST(StrokeNodes, TakeSpeedFromTime) {
  EXPECT_EQ(pen_inputs_present({}), 0u);
  EXPECT_EQ(pen_inputs_present({.time = true}), BURIN_INPUT_SPEED | BURIN_INPUT_TIME);
  EXPECT_EQ(pen_inputs_present({.pressure = true, .tilt = true, .twist = true}),
            BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT | BURIN_INPUT_TWIST);
}

/// A chart of single nodes whose events a test makes by hand: slot = vertex.
class StrokeNodesEvents : public ::testing::Test {
 protected:
  StrokeNodesEvents() : live_(30) {}

  static ChartFrame frame(double t, float d = 0) { return {.t = t, .d = d, .e1 = Vec3f::UnitX()}; }
  static std::set<Index> set(const std::vector<Index>& indices) {
    EXPECT_EQ(std::set<Index>(indices.begin(), indices.end()).size(), indices.size()) << "each once";
    return {indices.begin(), indices.end()};
  }
  void begin(double computed_from = nowhere) { live_.begin_event(10, false, computed_from); }

  LiveChart live_;
};

TEST_F(StrokeNodesEvents, AreStaleWhenNewOrOther) {
  StrokeNodes nodes(live_, reading(BURIN_INPUT_T));
  begin();
  for (Index vertex = 1; vertex < 6; ++vertex) live_.set(vertex, vertex, frame(1), Vec3f::UnitZ());
  EXPECT_EQ(set(nodes.follow(test::straight_curve(), nowhere).stale), (std::set<Index>{1, 2, 3, 4, 5}));
  begin();
  live_.set(0, 0, frame(1), Vec3f::UnitZ());
  live_.set(1, 1, frame(1), Vec3f::UnitZ());
  live_.set(2, 2, frame(1 + 1e-15), Vec3f::UnitZ());
  live_.set(3, 3, frame(1, 0.1f), Vec3f::UnitZ());
  live_.remove(4);
  const StrokeChanges changes = nodes.follow(test::straight_curve(), nowhere);
  EXPECT_EQ(set(changes.stale), (std::set<Index>{0, 2, 3}));
  EXPECT_EQ(set(changes.vertices), (std::set<Index>{0, 2, 3, 4})) << "one lost its node";
}

TEST_F(StrokeNodesEvents, AreStaleWhereThePenIsOther) {
  StrokeNodes nodes(live_, reading(BURIN_INPUT_PRESSURE));
  const auto computed_again = [&](const SurfaceCurve& curve) {
    begin();
    live_.set(3, 3, frame(0.25), Vec3f::UnitZ());
    live_.set(4, 4, frame(0.75), Vec3f::UnitZ());
    return set(nodes.follow(curve, nowhere).stale);
  };
  SurfaceCurve curve = test::straight_curve();
  EXPECT_EQ(computed_again(curve), (std::set<Index>{3, 4}));
  EXPECT_EQ(computed_again(curve), (std::set<Index>{}));
  curve.points[2].pen.pressure = 0.5f;
  EXPECT_EQ(computed_again(curve), (std::set<Index>{4}));
}

TEST_F(StrokeNodesEvents, AreStaleInTheEndZone) {
  StrokeNodes nodes(live_, reading(BURIN_INPUT_T));
  begin();
  for (Index vertex = 0; vertex < 8; ++vertex) live_.set(vertex, vertex, frame(vertex), Vec3f::UnitZ());
  nodes.follow(test::straight_curve(), nowhere);
  begin(5);
  for (Index vertex = 5; vertex < 8; ++vertex) live_.set(vertex, vertex, frame(vertex), Vec3f::UnitZ());
  EXPECT_EQ(set(nodes.follow(test::straight_curve(), 6).stale), (std::set<Index>{6, 7}));
  begin(5);
  for (Index vertex = 5; vertex < 8; ++vertex) live_.set(vertex, vertex, frame(vertex), Vec3f::UnitZ());
  EXPECT_EQ(set(nodes.follow(test::straight_curve(), 3).stale), (std::set<Index>{3, 4, 5, 6, 7}))
      << "before what was computed too";
  EXPECT_EQ(set(nodes.in_zone(7).stale), (std::set<Index>{7}));
}

/// A curve along x of this length with a corner at x = 1.
SurfaceCurve cornered_curve(double length) {
  SurfaceCurve curve;
  for (int i = 0; i <= 100; ++i) {
    CurvePoint point = test::straight_curve().points[0];
    point.t = length * i / 100;
    point.at.position =
        point.t < 1 ? Vec3d(point.t, 0, 0).cast<float>() : Vec3d(1, 1 - point.t, 0).cast<float>();
    curve.points.push_back(point);
  }
  return curve;
}

// Of two nodes that no event computed again, the one inside of the corner comes to know of what follows it.
TEST_F(StrokeNodesEvents, AreStaleNearTheBeginWhereTheirDistanceFromTheEndsIsOther) {
  StrokeNodes nodes(live_, reading(BURIN_INPUT_END_DISTANCE));
  const EndDistances shorter(cornered_curve(1.3), 1, 1.2), longer(cornered_curve(2.6), 1, 1.2);
  ASSERT_TRUE(shorter.begin_bends() && longer.begin_bends());
  begin();
  live_.set(3, 3, frame(0.7, -0.28f), Vec3f::UnitZ());
  live_.set(4, 4, frame(0.1, 0.1f), Vec3f::UnitZ());
  EXPECT_EQ(set(nodes.follow(cornered_curve(1.3), nowhere, 0, {&shorter, 1.2}).stale),
            (std::set<Index>{3, 4}));
  EXPECT_EQ(nodes.end_distance()[3], shorter.at(0.7, -0.28f, Vec3f::UnitX(), Vec3f::UnitZ()));
  begin(1);
  EXPECT_EQ(set(nodes.follow(cornered_curve(2.6), 2, 0, {&longer}).stale), (std::set<Index>{}));
  begin(1);
  EXPECT_EQ(set(nodes.follow(cornered_curve(2.6), 2, 0, {&longer, 1.2}).stale), (std::set<Index>{3}));
  EXPECT_EQ(nodes.end_distance()[3], longer.at(0.7, -0.28f, Vec3f::UnitX(), Vec3f::UnitZ()));
}

TEST_F(StrokeNodesEvents, AreStaleForWhoReadsSheetsWhenOneAppears) {
  const auto stale_after_a_sheet = [&](std::uint64_t inputs) {
    live_.clear();
    StrokeNodes nodes(live_, reading(inputs));
    begin();
    live_.set(3, 3, frame(5), Vec3f::UnitZ());
    live_.set(4, 4, frame(5), Vec3f::UnitZ());
    nodes.follow(test::straight_curve(), nowhere);
    begin();
    live_.set(9, 3, frame(1), Vec3f::UnitZ());
    const StrokeChanges changes = nodes.follow(test::straight_curve(), nowhere);
    EXPECT_EQ(set(changes.vertices), (std::set<Index>{3}));
    return set(changes.stale);
  };
  EXPECT_EQ(stale_after_a_sheet(BURIN_INPUT_T), (std::set<Index>{9}));
  EXPECT_EQ(stale_after_a_sheet(BURIN_INPUT_SHEET), (std::set<Index>{3, 9}));
  EXPECT_EQ(stale_after_a_sheet(BURIN_INPUT_VISIT_COUNT), (std::set<Index>{3, 9}));
}

}  // namespace
}  // namespace burin
