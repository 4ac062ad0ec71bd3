#include <burin/chart/front/front.h>
#include <burin/chart/front/near_neighbours.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sanitizers/processor_seconds.h"
#include "sanitizers/sanitized.h"
#include "support/traced.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

Index hub_of(const Surface& surface) {
  return static_cast<Index>(std::ranges::find(surface.source_vertex, 0u) - surface.source_vertex.begin());
}

TEST(NearNeighbours, AreAllOfFewAndOfManyThoseWithinReachAscending) {
  const Surface few = make_surface(test::fan(NearNeighbours::most_listed)),
                many = make_surface(test::fan(3000));
  const ChartGround few_ground(few), many_ground(many);
  NearNeighbours of_few(few_ground), of_many(many_ground);
  EXPECT_EQ(of_few.around(hub_of(few), {1, 0, 0}, 0.1).size(), NearNeighbours::most_listed);

  const auto found = of_many.around(hub_of(many), {1, 0, 0}, 0.1);
  EXPECT_TRUE(std::ranges::is_sorted(found));
  std::vector<Index> expected;
  for (Index vertex = 0; vertex < many.vertex_count(); ++vertex)
    if ((many.positions[vertex] - Vec3f::UnitX()).norm() < 0.1F) expected.push_back(vertex);
  EXPECT_GT(expected.size(), 90u);
  EXPECT_TRUE(std::ranges::equal(found, expected));
}

/// A stroke from near the hub out over the rim and back, on a disc of radius 1.
std::vector<Vec3d> over_the_rim() {
  return test::sampled(40, [](double s) { return Vec3d(0.05 + 0.94 * s, 0.3 * s * s, 0); });
}

TEST(NearNeighbours, LeaveTheChartOfAFanExactAndTheSameAsItGrows) {
  const Surface surface = make_surface(test::fan(20000));
  const Picker picker(surface);
  const ChartGround ground(surface);
  constexpr double radius = 0.03;
  Front fresh(ground), growing(ground);
  growing.restart(radius, 2);
  const std::vector<Vec3d> samples = over_the_rim();
  for (std::size_t count = 2; count <= samples.size(); count += 2) {
    const SurfaceCurve curve =
        test::traced(surface, picker, radius, {samples.begin(), samples.begin() + static_cast<long>(count)});
    growing.update(curve);
    fresh.restart(radius, 2);
    fresh.update(curve);
    const auto grown = growing.inside(), expected = fresh.inside();
    ASSERT_TRUE(std::ranges::equal(grown[0], expected[0], [](const FrontNode* a, const FrontNode* b) {
      return a->vertex() == b->vertex() && a->frame == b->frame;
    })) << count;
  }
  const SurfaceCurve& curve = fresh.stroke().curve;
  std::size_t under_the_pen = 0;
  for (const Vec3f& position : surface.positions) {
    float nearest = 1;
    for (std::size_t i = 0; i < curve.segment_count(); ++i)
      nearest = std::min(nearest, foot_on(curve, i, position).distance);
    under_the_pen += nearest < 0.999F * static_cast<float>(radius);
  }
  EXPECT_GT(under_the_pen, 100u);
  EXPECT_GE(fresh.inside()[0].size(), under_the_pen);
}

// All 100,000 vertices of the rim were offered each of the stroke's 600 segments around the hub: 4 s.
TEST(NearNeighbours, BoundTheCostOfAStrokeAtTheHubOfAFan) {
  const Surface surface = make_surface(test::fan(100000));
  const Picker picker(surface);
  const ChartGround ground(surface);
  Front front(ground);
  front.restart(0.01, 2);
  const SurfaceCurve curve = test::traced(
      surface, picker, 0.01, test::sampled(10, [](double s) { return Vec3d(0.4 - 0.8 * s, 0.01, 0); }));
  EXPECT_GT(curve.segment_count(), 500u);
  const double seconds = test::processor_seconds([&] { front.update(curve); });
  if (!test::sanitized) {
    EXPECT_LT(seconds, 1);
  }
}

}  // namespace
}  // namespace burin
