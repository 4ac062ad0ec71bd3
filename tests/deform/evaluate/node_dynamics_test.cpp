#include <burin/deform/evaluate/node_dynamics.h>
#include <gtest/gtest.h>

#include "deform/deform_fixtures.h"
#include "deform/varying_brush.h"

namespace burin {
namespace {

const DrivenStroke stroke{.fields = {.pressure = true}, .radius = 1, .seed = 0};

TEST(NodeDynamics, HoldNothingWhereNothingVaries) {
  const ParamDynamics none;
  for (const ParamDynamics* dynamics : {&none, static_cast<const ParamDynamics*>(nullptr)}) {
    NodeDynamics nodes(dynamics);
    nodes.resize(4);
    EXPECT_FALSE(nodes.any());
    EXPECT_TRUE(nodes.params().empty());
    EXPECT_EQ(nodes.strength(3), 1);
  }
}

TEST(NodeDynamics, TellWhetherAnyValueDiffers) {
  const test::VaryingBrush brush;
  const std::vector<Dynamic> of_all{{"strength", PenSource::pressure, {0, 0, 1, 1}},
                                    {"size", PenSource::t, {0, 0.5, 1, 1}}};
  const ParamDynamics dynamics(brush.descriptor, brush.params, of_all, stroke);
  NodeDynamics nodes(&dynamics);
  nodes.resize(3);
  PenAt at;
  at.pen.pressure = 0.5F;
  at.t = 0.5;
  EXPECT_TRUE(nodes.update(2, at, 0));
  EXPECT_FALSE(nodes.update(2, at, 0));
  EXPECT_EQ(nodes.strength(2), 0.5F);
  EXPECT_EQ(nodes.value(2, 0), 1.5F);
  at.pen.pressure = 0.25F;
  EXPECT_TRUE(nodes.update(2, at, 0));
  at.t = 0.75;
  EXPECT_TRUE(nodes.update(2, at, 0));
  EXPECT_EQ(nodes.strength(2), 0.25F);
  EXPECT_EQ(nodes.value(2, 0), 1.75F);
}

TEST(StrokeNodes, AreStaleWhereADynamicValueIsOther) {
  const test::VaryingBrush brush;
  const std::vector<Dynamic> size{{"size", PenSource::pressure, {0, 1, 1, 2}}};
  const ParamDynamics dynamics(brush.descriptor, brush.params, size, stroke);
  LiveChart live(30);
  StrokeNodes nodes(live, {.dynamics = &dynamics});
  const auto stale_after = [&](const SurfaceCurve& curve) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    live.begin_event(10, false, nowhere);
    live.set(3, 3, {.t = 0.25, .d = 0, .e1 = Vec3f::UnitX()}, Vec3f::UnitZ());
    live.set(4, 4, {.t = 0.75, .d = 0, .e1 = Vec3f::UnitX()}, Vec3f::UnitZ());
    return nodes.follow(curve, nowhere).stale;
  };
  SurfaceCurve curve = test::straight_curve();
  EXPECT_EQ(stale_after(curve), (std::vector<Index>{3, 4}));
  EXPECT_EQ(nodes.dynamics().value(3, 0), 2.5F);
  EXPECT_EQ(nodes.dynamics().value(4, 0), 3.5F);
  EXPECT_EQ(stale_after(curve), (std::vector<Index>{}));
  curve.points[2].pen.pressure = 0.5F;
  EXPECT_EQ(stale_after(curve), (std::vector<Index>{4}));
  EXPECT_EQ(nodes.dynamics().value(4, 0), 3);
}

}  // namespace
}  // namespace burin
