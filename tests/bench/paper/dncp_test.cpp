#include "dncp.h"

#include <gtest/gtest.h>

#include "strips.h"

namespace burin::paper {
namespace {

Parameterization solved(const Subject& subject, std::span<const Constraint> constraints) {
  SolveTimes times;
  return dncp(flatten(subject.scene->surface, subject.region), subject.region, constraints, times);
}

TEST(Dncp, UnrollsWhatCanBeUnrolled) {
  for (const Scene& scene : {planar_scene(), prism_scene()}) {
    const Subject subject = straight_subject(scene);
    for (const auto& constraints : both_constraints(subject)) {
      const Parameterization places = solved(subject, constraints);
      EXPECT_LE(largest_difference(places, chart_coordinates(subject)), 1e-3 * subject.radius) << scene.name;
      EXPECT_LE(largest_miss(places, constraints), 1e-5 * subject.radius);
    }
  }
}

// Two points alone: their similarity.
TEST(Dncp, ScalesWithItsConstraints) {
  const Scene scene = planar_scene();
  const Subject subject = straight_subject(scene);
  auto constraints = vertices_near_stroke(subject.region, subject.chart, subject.curve);
  constraints = {constraints.front(), constraints.back()};
  for (Constraint& constraint : constraints) constraint.target *= 3;
  const Parameterization places = solved(subject, constraints);
  EXPECT_LE(largest_difference(places, 3 * chart_coordinates(subject)), 1e-2 * subject.radius);
  EXPECT_EQ(flipped(subject.region, places), 0);
}

}  // namespace
}  // namespace burin::paper
