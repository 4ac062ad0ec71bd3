#include "support/shapes.h"

#include <burin/chart/live_dabs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace burin {
namespace {

constexpr double radius = 0.12, spacing = 0.09;

class LiveDabsTest : public ::testing::Test {
 protected:
  LiveDabsTest()
      : surface_(make_surface(test::shuffled(test::plane(1, 0.02, 8), 9))),
        picker_(surface_),
        tracer_(surface_, picker_, radius) {}

  void add(double x, double y) {
    const auto at = picker_.closest(Vec3f(static_cast<float>(x), static_cast<float>(y), 0), 0.1f);
    ASSERT_TRUE(at);
    tracer_.add(*at, time_ += 0.01, {});
  }

  Surface surface_;
  Picker picker_;
  CurveTracer tracer_;
  double time_ = 0;
};

/// What the nodes of each vertex say, by t.
std::map<std::pair<Index, double>, Vec3f> content(const LiveDabs& dabs) {
  const LiveChart& live = dabs.live();
  std::map<std::pair<Index, double>, Vec3f> nodes;
  for (Index slot = 0; slot < live.nodes().size(); ++slot)
    if (!live.vacant(slot))
      nodes[{live.nodes().vertex[slot], live.nodes().t[slot]}] = {dabs.along()[slot], live.nodes().d[slot],
                                                                  live.nodes().e1[slot].x()};
  return nodes;
}

TEST_F(LiveDabsTest, PutsNormalCoordinatesAroundPlacesAlongTheCurve) {
  for (int i = 0; i <= 20; ++i) add(-0.5 + 0.05 * i, 0.1);
  LiveDabs dabs(surface_, picker_);
  dabs.begin(radius, spacing);
  const LiveChart& live = dabs.draw(tracer_.curve());
  std::map<double, std::size_t> nodes_of;
  for (Index slot = 0; slot < live.nodes().size(); ++slot) {
    const Vec3f& place = surface_.positions[live.nodes().vertex[slot]];
    const double t = live.nodes().t[slot];
    ++nodes_of[t];
    ASSERT_NEAR(dabs.along()[slot], place.x() + 0.5 - t, 1e-4);
    ASSERT_NEAR(live.nodes().d[slot], place.y() - 0.1, 1e-4);
  }
  ASSERT_EQ(nodes_of.size(), 12u) << "at 0, 0.09, ... 0.99 of 1";
  // A disc of 0.12 covers about 113 cells of 0.02.
  for (const auto& [t, nodes] : nodes_of) EXPECT_NEAR(static_cast<double>(nodes), 113, 25) << t;
  EXPECT_EQ(dabs.settled(), live.nodes().size());
}

TEST_F(LiveDabsTest, GrowToWhatAllAtOnceGives) {
  LiveDabs growing(surface_, picker_);
  growing.begin(radius, spacing);
  std::size_t unchanged = 0;
  for (int i = 0; i <= 40; ++i) {
    add(-0.7 + 0.035 * i, 0.3 * std::sin(0.2 * i));
    growing.draw(tracer_.curve(), unchanged);
    unchanged = tracer_.final_points();
    LiveDabs fresh(surface_, picker_);
    fresh.begin(radius, spacing);
    fresh.draw(tracer_.curve());
    ASSERT_EQ(content(growing), content(fresh)) << i;
  }
  EXPECT_LT(growing.settled(), content(growing).size() / 4) << "the last event computes the last dabs only";
}

TEST_F(LiveDabsTest, GoAroundAClosedCurveInAWholeNumber) {
  for (int i = 0; i < 60; ++i) add(0.4 * std::cos(0.105 * i), 0.4 * std::sin(0.105 * i));
  const auto closed = tracer_.closed_curve(Closure::closed);
  ASSERT_TRUE(closed);
  LiveDabs dabs(surface_, picker_);
  dabs.begin(radius, spacing);
  const LiveChart& live = dabs.draw(*closed);
  std::vector<double> t(live.nodes().t.begin(), live.nodes().t.end());
  std::ranges::sort(t);
  const auto [first, last] = std::ranges::unique(t);
  t.erase(first, last);
  const auto count = static_cast<std::size_t>(std::round(closed->length() / spacing));
  ASSERT_EQ(t.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_NEAR(t[i], static_cast<double>(i) * closed->length() / static_cast<double>(count), 1e-9);
}

}  // namespace
}  // namespace burin
