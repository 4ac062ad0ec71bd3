#include <burin/feature/level_image.h>
#include <gtest/gtest.h>

#include <cmath>

#include "feature/known_lines.h"
#include "support/scene.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin::test {
namespace {

/// The smoothed geometry around a stroke of radius 8 on a cylinder of radius 20 about the z axis, with edges
/// of 1.
SmoothedImage geometry_around(const std::vector<Vec3d>& pen) {
  Scene scene(shuffled(cylinder(20, 30, 1, 0.3, 3), 4));
  const SurfaceCurve curve = traced(scene.surface, scene.picker, 8, pen);
  const Chart chart = scene.builder.chart(curve, {.radius = 8});
  const ChartSamples samples(scene.surface, chart, chart_grid(curve.length(), false, 8, 1, 6));
  return smoothed_image(samples, geometry_of(samples, &ChartSample::mean_normal), geometry_channels, {2, 2});
}

double median_of(const LevelImage& level) {
  std::vector<double> values;
  for (const float value : level.values)
    if (!std::isnan(value)) values.push_back(static_cast<double>(value));
  EXPECT_GT(values.size(), 300u);
  std::ranges::sort(values);
  return quantile(values, 0.5);
}

std::vector<Vec3d> around_the_axis() {
  return sampled(30, [](double s) { return Vec3d(20 * std::cos(1.5 * s), 20 * std::sin(1.5 * s), 6 * s); });
}

TEST(LevelImage, OfCurvatureIsThatOfTheSurfaceWhateverTheStroke) {
  const std::vector<Vec3d> along = sampled(30, [](double s) { return Vec3d(20, 0, 30 * s - 15); });
  for (const auto& pen : {around_the_axis(), along}) {
    const SmoothedImage geometry = geometry_around(pen);
    EXPECT_NEAR(median_of(curvature_image(geometry, 1)), 1. / 20, 0.02 / 20);
    EXPECT_NEAR(median_of(curvature_image(geometry, -1)), 0, 0.03 / 20) << "of the opposite surface";
  }
}

TEST(LevelImage, OfFacingIsTheCosineToTheViewer) {
  const SmoothedImage geometry = geometry_around(around_the_axis());
  const Vec3f middle = to_viewer({true, Vec3d(0, 0, 5)}, Vec3f(0, 0, 1));
  EXPECT_NEAR((middle - Vec3f::UnitZ()).norm(), 0, 1e-6);
  EXPECT_NEAR((to_viewer({false, Vec3d(0, 0, -2)}, Vec3f(7, 8, 9)) - Vec3f::UnitZ()).norm(), 0, 1e-6);
  const LevelImage facing = facing_image(geometry, Vec3f::Zero(), {false, Vec3d(-1, 0, 0)});
  // The first inner column is at the angle 0, where the normal is the x axis, the last at 1.5.
  EXPECT_NEAR(facing.at(facing.grid.margin, facing.grid.stroke_row()), 1, 0.01);
  EXPECT_NEAR(facing.at(facing.grid.columns - 1 - facing.grid.margin, facing.grid.stroke_row()),
              std::cos(1.5), 0.02);
}

}  // namespace
}  // namespace burin::test
