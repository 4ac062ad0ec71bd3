#pragma once
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include "support/chart_error.h"
#include "support/scene.h"
#include "support/traced.h"

namespace burin::test {

/// The errors of the chart of a straight stroke of radius 0.2, oblique to the edges, in the plane z = 0
/// around the origin, without those beyond its ends.
inline ChartError error_of_straight_stroke(Scene& scene) {
  const double radius = 0.2;
  const Vec3d from(-0.5, -0.31, 0), to(0.62, 0.27, 0);
  const Vec3d along = (to - from).normalized(), left(-along.y(), along.x(), 0);
  const SurfaceCurve curve = traced(scene.surface, scene.picker, radius,
                                    sampled(40, [&](double s) { return Vec3d(from + s * (to - from)); }));
  EXPECT_NEAR(curve.length(), (to - from).norm(), 1e-5 * radius);
  const Chart chart = scene.builder.chart(curve, {radius, Cap::round});
  return error_against(scene.surface, chart, curve.length(), radius, 0, [&](const Vec3d& x) {
    return Coordinates{(x - from).dot(along), (x - from).dot(left)};
  });
}

}  // namespace burin::test
