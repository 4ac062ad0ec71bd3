#include "support/shapes.h"

#include <burin/chart/dabs/live_dabs.h>
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

/// The frames of the nodes of each vertex, by t.
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

// The base surface of a cylinder is the cylinder, which unrolls to a plane.
TEST(LiveDabsOnBase, AreNormalCoordinatesOfAllVerticesAround) {
  constexpr double wide = 0.4;
  const Surface surface = make_surface(test::shuffled(test::cylinder(1, 1.5, 0.02, 0.3, 3), 4));
  const Picker picker(surface);
  const SurfaceLevels levels(surface);
  BaseSurface base(surface, levels);
  ASSERT_TRUE(base.set_radius(wide));
  CurveTracer tracer(CurveGround(surface, picker, &base), wide);
  for (int i = 0; i <= 40; ++i) {
    const double angle = 0.03 * i;
    const auto at = picker.closest(Vec3d(std::cos(angle), std::sin(angle), 0.1).cast<float>(), 0.1F);
    ASSERT_TRUE(at);
    tracer.add(*at, i, {});
  }
  LiveDabs dabs(surface, picker);
  dabs.begin(wide, 2 * wide, &base);
  const LiveChart& live = dabs.draw(tracer.curve());
  std::map<double, std::size_t> nodes_of;
  double worst = 0;
  for (Index slot = 0; slot < live.nodes().size(); ++slot) {
    const Vec3d place = surface.positions[live.nodes().vertex[slot]].cast<double>();
    const double t = live.nodes().t[slot];
    ++nodes_of[t];
    // The curve goes round anticlockwise, seen from +z, which is on its left.
    const double along = std::atan2(place.y(), place.x()) - t, across = place.z() - 0.1;
    worst = std::max({worst, std::abs(static_cast<double>(dabs.along()[slot]) - along),
                      std::abs(static_cast<double>(live.nodes().d[slot]) - across)});
    const Vec3d normal(place.x(), place.y(), 0), e1(-place.y(), place.x(), 0);
    EXPECT_GT(live.nodes().normal[slot].cast<double>().dot(normal.normalized()), 1 - 1e-4);
    EXPECT_GT(live.nodes().e1[slot].cast<double>().dot(e1.normalized()), 1 - 1e-3);
  }
  EXPECT_LT(worst, 2e-3 * wide);
  ASSERT_EQ(nodes_of.size(), 2U);
  std::size_t around = 0;  // vertices within the first dab
  for (const Vec3f& place : surface.positions)
    around += std::hypot(std::atan2(place.y(), place.x()), place.z() - 0.1F) < static_cast<float>(wide);
  EXPECT_NEAR(static_cast<double>(nodes_of.at(0)), static_cast<double>(around),
              0.01 * static_cast<double>(around));
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
