#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/chart_error.h"
#include "support/charted.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double unscaled_radius = 0.3;
constexpr double scales[] = {1e-12, 1e-9, 1e-6, 1, 1e6, 1e9, 1e12};

TriangleMesh scaled_plane(double scale) {
  TriangleMesh mesh = test::plane(1, 0.04, 7);
  for (Vec3f& position : mesh.positions) position = (position.cast<double>() * scale).cast<float>();
  return mesh;
}

/// Along a wave of this height.
std::vector<Vec3d> wave(double height, double scale) {
  std::vector<Vec3d> samples;
  for (int i = 0; i <= 60; ++i)
    samples.emplace_back(scale * Vec3d(-0.6 + 0.02 * i, height * std::sin(0.1 * i), 0));
  return samples;
}

TEST(Scale, LeavesRelativeErrorsAsTheyAre) {
  for (const double scale : scales) {
    test::Charted charted(scaled_plane(scale));
    const Chart chart = charted.chart({.radius = unscaled_radius * scale}, wave(0, scale));
    const auto error = test::error_against(charted.surface, chart, charted.curve.length(),
                                           unscaled_radius * scale, 0, [&](const Vec3d& x) {
                                             return test::Coordinates{x.x() + 0.6 * scale, x.y()};
                                           });
    EXPECT_GT(error.count, 400U) << scale;
    EXPECT_LT(error.d_max, 1e-5) << scale;
    EXPECT_LT(error.t_max, 1e-5) << scale;
  }
}

TEST(Scale, LeavesChartsOfCurvedStrokesAsTheyAre) {
  std::map<Index, float> at_one;
  for (const double scale : {1.0, 1e-12, 1e-9, 1e-6, 1e6, 1e9, 1e12}) {
    test::Charted charted(scaled_plane(scale));
    const Chart chart = charted.chart({.radius = unscaled_radius * scale}, wave(0.2, scale));
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Index source = charted.surface.source_vertex[chart.vertex[i]];
      const double d = chart.d[i] / scale;
      if (scale == 1) at_one[source] = static_cast<float>(d);
      if (!at_one.contains(source)) continue;
      sum += std::abs(std::abs(d) - std::abs(double{at_one[source]}));
      ++count;
    }
    EXPECT_GT(count, 0.98 * static_cast<double>(at_one.size())) << scale;
    EXPECT_LT(sum / count, 2e-3 * unscaled_radius) << scale;
  }
}

}  // namespace
}  // namespace burin
