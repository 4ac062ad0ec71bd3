#include <burin/chart/live_chart.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "support/same_chart.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double everywhere = -std::numeric_limits<double>::infinity();

ChartFrame frame(double t, float d = 0) { return {.t = t, .d = d, .e1 = Vec3f::UnitX()}; }

TEST(LiveChart, AgreesWithAMapOfNodesThroughRandomEvents) {
  const unsigned seed = 23;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  LiveChart live(20);
  std::map<Index, std::pair<Index, double>> expected;  // slot -> vertex, t
  std::size_t with_sheets = 0, unchanged = 0, removed = 0;
  for (int event = 0; event < 300; ++event) {
    live.begin_event(event, false, 0);
    std::set<Index> given, changed, altered;
    for (int i = 0; i < 8; ++i) {
      const auto slot = static_cast<Index>(random() % 60);
      if (!given.insert(slot).second) continue;
      const Index vertex = slot % 20;
      if (random() % 3 == 0) {
        removed += expected.count(slot);
        if (expected.erase(slot)) altered.insert(vertex);
        live.remove(slot);
        continue;
      }
      const double t = (random() % 2 == 0 ? 0 : 1) + 0.01 * slot;
      const bool same = expected.count(slot) && expected[slot].second == t;
      unchanged += same;
      if (!same) {
        changed.insert(slot);
        altered.insert(vertex);
      }
      expected[slot] = {vertex, t};
      live.set(slot, vertex, frame(t), Vec3f::UnitZ());
    }
    EXPECT_EQ(std::set<Index>(live.altered().begin(), live.altered().end()), altered);
    EXPECT_EQ(live.altered().size(), altered.size()) << "each once";
    for (const Index slot : live.computed()) EXPECT_EQ(live.changed(slot), changed.count(slot) > 0);
    for (Index vertex = 0; vertex < 20; ++vertex) {
      std::multimap<double, Index> of_vertex;
      for (const auto& [slot, node] : expected)
        if (node.first == vertex) of_vertex.emplace(node.second, slot);
      ASSERT_EQ(live.sheet_count(vertex), of_vertex.size());
      with_sheets += of_vertex.size() > 1;
      std::uint32_t sheet = 0;
      Index slot = live.first(vertex);
      for (const auto& [t, expected_slot] : of_vertex) {
        ASSERT_EQ(slot, expected_slot);
        EXPECT_EQ(live.nodes().t[slot], t);
        EXPECT_EQ(live.nodes().sheet[slot], sheet++);
        slot = live.next(slot);
      }
    }
  }
  EXPECT_GT(with_sheets, 500u);
  EXPECT_GT(unchanged, 100u);
  EXPECT_GT(removed, 100u);
}

TEST(LiveChart, TellsWhatAnAssignedChartChanges) {
  LiveChart live(10);
  live.begin_event(1, false, everywhere);
  live.set(0, 4, frame(1), Vec3f::UnitZ());
  live.set(1, 5, frame(1), Vec3f::UnitZ());
  Chart chart;
  chart.vertex = {5, 6};
  chart.sheet = {0, 0};
  chart.t = {1, 2};
  chart.d = {0, 0};
  chart.e1 = {Vec3f::UnitX(), Vec3f::UnitX()};
  chart.normal = {Vec3f::UnitZ(), Vec3f::UnitZ()};
  chart.stretch = {1, 1};
  chart.curvature = {0, 0};
  chart.length = 7;
  chart.closed = true;
  live.assign(chart);
  EXPECT_EQ(std::set<Index>(live.altered().begin(), live.altered().end()), (std::set<Index>{4, 6}));
  EXPECT_EQ(live.first(4), no_index);
  test::expect_same(live.sorted(), chart);
}

/// The changes that draw() reports, applied event by event, give the result of chart().
TEST(LiveChart, FollowsAGrowingStroke) {
  const Surface surface = make_surface(test::shuffled(test::sphere(5, 0.2, 3), 4));
  const Picker picker(surface);
  StrokeChartBuilder builder(surface), fresh(surface);
  for (const Cap cap : {Cap::round, Cap::butt}) {
    const ChartOptions options{.radius = 0.25, .cap = cap};
    builder.begin(options);
    CurveTracer tracer(surface, picker, options.radius);
    std::size_t most_computed = 0, nodes = 0;
    for (int i = 0; i < 60; ++i) {
      const double a = 0.11 * i;  // around a small circle, and on over its own beginning
      const Vec3f place = Vec3d(std::cos(a), std::sin(a), 0.6 + 0.01 * i).normalized().cast<float>();
      const std::size_t unchanged = tracer.final_points();
      tracer.add(*picker.closest(place, 0.1f), 0, {});
      const LiveChart& live = builder.draw(tracer.curve(), unchanged);
      if (i > 20) most_computed = std::max(most_computed, live.computed().size());
      const Chart expected = fresh.chart(tracer.curve(), options);
      nodes = expected.size();
      test::expect_same(live.sorted(), expected);
      for (Index slot = 0; slot < live.nodes().size(); ++slot) {
        if (live.vacant(slot) || live.nodes().t[slot] < live.computed_from()) continue;
        ASSERT_TRUE(std::ranges::count(live.computed(), slot)) << slot;
      }
    }
    EXPECT_LT(most_computed, nodes / 2) << "events cost what they change";
  }
}

}  // namespace
}  // namespace burin
