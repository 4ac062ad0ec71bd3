#pragma once
#include <cmath>

#include "constraints.h"
#include "subject.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin::paper {

inline Scene planar_scene() { return {"plane", make_surface(test::shuffled(test::plane(0.6, 0.02, 7), 8))}; }

inline Scene prism_scene() {
  return {"prism", make_surface(test::shuffled(test::cylinder(0.5, 0.6, 0.02, 0, 5), 6))};
}

/// A straight stroke across one of them, whose (t, d) is an isometry.
inline Subject straight_subject(const Scene& scene) {
  const double radius = 0.15;
  std::vector<Vec3d> samples;
  for (double s = -0.4; s < 0.41; s += 0.02)
    samples.push_back(scene.name == "plane" ? Vec3d(s, 0.2 * s, 0) : Vec3d(0.5, 0, s));
  return make_subject(scene, test::traced(scene.surface, scene.picker, radius, samples), radius);
}

inline std::array<std::vector<Constraint>, 2> both_constraints(const Subject& subject) {
  return {vertices_near_stroke(subject.region, subject.chart, subject.curve),
          points_on_stroke(subject.region, subject.curve)};
}

inline double largest_difference(const Parameterization& a, const Parameterization& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace burin::paper
