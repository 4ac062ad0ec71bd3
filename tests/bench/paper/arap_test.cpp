#include "arap.h"

#include <gtest/gtest.h>

#include "strips.h"

namespace burin::paper {
namespace {

/// Solves from an initial state that is far too narrow.
Parameterization solved(const Subject& subject, std::span<const Constraint> constraints, int iterations) {
  SolveTimes times;
  Parameterization narrow = chart_coordinates(subject);
  narrow.col(1) *= 0.3;
  return arap(flatten(subject.scene->surface, subject.region), subject.region, constraints, narrow,
              iterations, times);
}

TEST(Arap, UnrollsWhatCanBeUnrolled) {
  for (const Scene& scene : {planar_scene(), prism_scene()}) {
    const Subject subject = straight_subject(scene);
    for (const auto& constraints : both_constraints(subject)) {
      const Parameterization places = solved(subject, constraints, 100);
      EXPECT_LE(largest_difference(places, chart_coordinates(subject)), 1e-3 * subject.radius) << scene.name;
      EXPECT_LE(largest_miss(places, constraints), 1e-5 * subject.radius);
    }
  }
}

TEST(Arap, LowersItsEnergyStepByStep) {
  const Scene scene("sphere", make_surface(test::sphere(5, 0.15, 3)));
  std::vector<Vec3d> samples;
  for (double s = 0; s < 1.5; s += 0.02)
    samples.push_back(Vec3d(std::cos(s), std::sin(s), 0.3 * std::sin(4 * s)).normalized());
  const Subject subject = make_subject(scene, test::traced(scene.surface, scene.picker, 0.4, samples), 0.4);
  const auto triangles = flatten(scene.surface, subject.region);
  const auto constraints = points_on_stroke(subject.region, subject.curve);
  double before = arap_energy(triangles, subject.region, solved(subject, constraints, 1));
  EXPECT_GT(before, 1e-3);
  for (const int iterations : {2, 3, 5, 10, 20}) {
    const double after = arap_energy(triangles, subject.region, solved(subject, constraints, iterations));
    EXPECT_LT(after, before) << iterations;
    before = after;
  }
}

}  // namespace
}  // namespace burin::paper
