// Tests charts that are interpolated from base surfaces: strokes over relief that is narrow compared with
// the brush, and growing strokes compared with fresh ones. shooting_test.cpp measures accuracy on smooth
// surfaces.
#include <burin/base/parallel.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "support/same_chart.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

constexpr double radius = 1;

/// A surface over the rectangle |x| <= 3.5, |y| <= 2 with an egg crate of wavelength 0.35, and what strokes
/// on its base surface need.
struct Bumpy {
  explicit Bumpy(double amplitude)
      : surface(make_surface(test::shuffled(
            test::patch({.u_min = -3.5, .u_max = 3.5, .v_min = -2, .v_max = 2, .cells_u = 140, .cells_v = 80},
                        [=](double x, double y) {
                          const double k = 2 * std::numbers::pi / 0.35;
                          return Vec3d(x, y, amplitude * std::sin(k * x) * std::sin(k * y));
                        }),
            3))),
        picker(surface),
        levels(surface),
        builder(surface, &levels) {}

  /// The curve of a pen seen from above.
  CurveTracer trace(int samples) {
    CurveTracer tracer(CurveGround(surface, picker, builder.base()), radius);
    for (int i = 0; i < samples; ++i) {
      const auto x = static_cast<float>(-2 + 4. * i / (samples - 1));
      const auto at = picker.pick({.origin = {x, 0.4F * std::sin(1.2F * x), 5}, .direction = {0, 0, -1}});
      EXPECT_TRUE(at && tracer.connects(*at)) << "sample " << i;
      if (at) tracer.add(*at, i / 240., {});
    }
    return tracer;
  }

  Surface surface;
  Picker picker;
  SurfaceLevels levels;
  StrokeChartBuilder builder;
};

constexpr ChartOptions felt_at_own_scale{.radius = radius, .follow = 0};

std::map<Index, std::pair<double, double>> by_source(const Surface& surface, const Chart& chart) {
  std::map<Index, std::pair<double, double>> coordinates;
  for (std::size_t i = 0; i < chart.size(); ++i)
    coordinates[surface.source_vertex[chart.vertex[i]]] = {chart.t[i], chart.d[i]};
  return coordinates;
}

// The bumps stand on the vertices of the plane; what they change of its coordinates away from the stroke's
// ends, as in shooting_test.cpp, is the error.
TEST(ChartTransfer, GivesBumpyGroundTheCoordinatesOfThePlaneBelow) {
  Bumpy flat(0);
  flat.builder.begin({.radius = radius});
  const Chart plane = flat.builder.draw(flat.trace(200).curve()).sorted();
  const auto exact = by_source(flat.surface, plane);
  ASSERT_GT(exact.size(), 3000U);
  for (const double amplitude : {0.01, 0.05, 0.12}) {
    Bumpy bumpy(amplitude);
    bumpy.builder.begin(felt_at_own_scale);
    ASSERT_NE(bumpy.builder.base(), nullptr);
    const Chart chart = bumpy.builder.draw(bumpy.trace(200).curve()).sorted();
    double squares = 0;
    std::size_t found = 0;
    for (const auto& [vertex, coordinates] : by_source(bumpy.surface, chart)) {
      const auto at = exact.find(vertex);
      const bool is_near_end =
          coordinates.first < radius / 3 || coordinates.first > chart.length - radius / 3;
      if (at == exact.end() || is_near_end) continue;
      squares += std::pow(coordinates.first - at->second.first, 2) +
                 std::pow(coordinates.second - at->second.second, 2);
      ++found;
    }
    EXPECT_GT(found, 2000U) << "bumps of " << amplitude;
    EXPECT_NEAR(static_cast<double>(chart.size()), static_cast<double>(exact.size()),
                0.01 * static_cast<double>(exact.size()));
    EXPECT_LT(std::sqrt(squares / static_cast<double>(found)), 0.01 * radius) << "bumps of " << amplitude;
    for (std::size_t i = 0; i < chart.size(); ++i)
      ASSERT_GT(chart.normal[i].z(), 0.995F) << "bumps of " << amplitude;
  }
}

TEST(ChartTransfer, GrowsBitForBitIntoTheFreshChart) {
  Bumpy bumpy(0.05), fresh(0.05);
  bumpy.builder.begin(felt_at_own_scale);
  CurveTracer tracer(CurveGround(bumpy.surface, bumpy.picker, bumpy.builder.base()), radius);
  for (int i = 0; i < 60; ++i) {
    const float s = static_cast<float>(i) / 59;
    const auto at =
        bumpy.picker.pick({.origin = {-1.5F + 3 * s, 0.8F * std::sin(4 * s), 5}, .direction = {0, 0, -1}});
    ASSERT_TRUE(at.has_value());
    const std::size_t unchanged = tracer.final_points();
    tracer.add(*at, i / 240., {});
    const Chart grown = bumpy.builder.draw(tracer.curve(), unchanged).sorted();
    if (i % 10 != 9) continue;
    const ThreadLimit one_thread(1);
    test::expect_same(grown, fresh.builder.chart(tracer.curve(), felt_at_own_scale));
  }
}

TEST(ChartTransfer, FollowsAllReliefWhereTheSurfaceIsCoarse) {
  const Surface surface = make_surface(test::sphere(2, 0, 1));
  const SurfaceLevels levels(surface);
  StrokeChartBuilder builder(surface, &levels);
  builder.begin({.radius = 0.3, .follow = 0});
  EXPECT_EQ(builder.base(), nullptr);
}

}  // namespace
}  // namespace burin
