#include <burin/chart/front/leader.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 0.2;

StrokePath straight_path() {
  const Surface surface = make_surface(test::plane(1, 0.05, 3));
  const SurfaceCurve curve = test::traced(surface, Picker(surface), radius, {{-0.8, 0, 0}, {0.8, 0, 0}});
  GeodesicCurvature curvature;
  curvature.update(curve, radius / 4);
  StrokePath path;
  path.update(curve, curvature, radius, 0, 0);
  return path;
}

/// A node beside the stroke along x through (-0.8, 0), as exact frames have it.
FrontNode node_at(const Vec3f& position) {
  FrontNode node;
  node.position = position;
  node.normal = Vec3f::UnitZ();
  node.frame = {.t = 0.8 + static_cast<double>(position.x()), .d = position.y(), .e1 = Vec3f::UnitX()};
  node.set_g(std::abs(position.y()));
  return node;
}

TEST(Leader, LeadsToTheDistanceFromAStraightStroke) {
  const StrokePath path = straight_path();
  const FrontNode node = node_at({0.1F, 0.05F, 0});
  for (const Vec3f& x : {Vec3f(0.13F, 0.09F, 0), Vec3f(0.08F, 0.1F, 0), Vec3f(0.1F, 0.085F, 0)}) {
    const Leader::Way way = Leader(node, path).to(x);
    EXPECT_NEAR(way.g, x.y(), 1e-6F);
    EXPECT_NEAR(way.length, (x - node.position).norm(), 1e-7F);
    EXPECT_NEAR(way.least_t, 0.8 + static_cast<double>(std::min(x.x(), 0.1F)), 1e-6);
    EXPECT_NEAR(way.most_t, 0.8 + static_cast<double>(std::max(x.x(), 0.1F)), 1e-6);
  }
}

TEST(Leader, DoesNotLeadOnWithoutProgress) {
  const StrokePath path = straight_path();
  const FrontNode node = node_at({0.1F, 0.05F, 0});
  const Vec3f back(0.1F, 0.02F, 0);
  EXPECT_GT(Leader(node, path).to(back).g, node.g() + 0.3F * 0.03F);
}

}  // namespace
}  // namespace burin
