#include "chart/chart_check.h"

#include <burin/chart/stroke_chart_builder.h>
#include <burin/stroke/stroke_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host_stub/run_command.h"
#include "support/charted.h"
#include "support/shapes.h"

namespace burin::command {
namespace {

constexpr double radius = 0.2;

std::vector<Vec3d> bow(double height) {
  return test::sampled(40, [=](double s) { return Vec3d(1.2 * (s - 0.5), 0.2 * std::sin(3 * s), height); });
}

std::vector<Vec3d> bow_on_sphere() {
  std::vector<Vec3d> samples = bow(0.8);
  for (Vec3d& sample : samples) sample.normalize();
  return samples;
}

TEST(ChartCheck, FindsNothingWrongOnThePlane) {
  test::Charted on(test::plane(1, 0.02, 3));
  const Chart chart = on.chart({.radius = radius}, bow(0));
  const ChartCheck check = check_chart(on.surface, on.picker, on.curve, chart, radius, Join::round);
  EXPECT_GT(check.under_pen, 500U);
  EXPECT_EQ(check.holes, 0U);
  ASSERT_TRUE(check.distances.has_value());
  EXPECT_FALSE(check.distances->sphere);
  EXPECT_LT(check.distances->worst, 0.005);
  EXPECT_GT(check.distances->worst, 0);
}

// The points of a curve on a base surface name its nodes, not vertices.
TEST(ChartCheck, CountsTheSameVerticesAtTheBrushesOwnScale) {
  test::Charted on(test::plane(1, 0.008, 3));
  std::vector<std::size_t> counts;
  for (const double follow : {0., 1.}) {
    const Chart chart = on.chart({.radius = radius, .follow = follow}, bow(0));
    const ChartCheck check = check_chart(on.surface, on.picker, on.curve, chart, radius, Join::round);
    EXPECT_EQ(check.holes, 0U);
    ASSERT_TRUE(check.distances.has_value());
    EXPECT_LT(check.distances->worst, 0.005);
    counts.push_back(check.under_pen);
  }
  EXPECT_GT(counts[1], 5000U);
  EXPECT_NEAR(static_cast<double>(counts[0]), static_cast<double>(counts[1]),
              0.01 * static_cast<double>(counts[1]));
}

TEST(ChartCheck, FindsNothingWrongOnTheSphere) {
  test::Charted on(test::sphere(6, 0.1, 3));
  const Chart chart = on.chart({.radius = radius}, bow_on_sphere());
  const ChartCheck check = check_chart(on.surface, on.picker, on.curve, chart, radius, Join::round);
  EXPECT_EQ(check.holes, 0U);
  ASSERT_TRUE(check.distances.has_value());
  EXPECT_TRUE(check.distances->sphere);
  EXPECT_LT(check.distances->worst, 0.005);
}

TEST(ChartCheck, CountsNodesThatAreMissingOrWrong) {
  test::Charted on(test::plane(1, 0.02, 3));
  Chart chart = on.chart({.radius = radius}, bow(0));
  std::size_t taken = 0, moved = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (std::abs(chart.d[i]) > 0.3 * radius) continue;
    if (i % 50 == 0) {
      chart.vertex[i] = no_index;
      ++taken;
    } else if (i % 50 == 1) {
      chart.d[i] += static_cast<float>(std::copysign(0.3 * radius, chart.d[i]));
      ++moved;
    }
  }
  ASSERT_GT(taken, 3U);
  const ChartCheck check = check_chart(on.surface, on.picker, on.curve, chart, radius, Join::round);
  EXPECT_EQ(check.holes, taken);
  EXPECT_EQ(check.distances->off_2, moved);
  EXPECT_EQ(check.distances->off_10, moved);
  EXPECT_NEAR(check.distances->worst, 0.3, 0.01);
}

TEST(ChartCheck, KnowsNoDistancesOnOtherSurfaces) {
  test::Charted on(
      test::patch({.u_min = -1, .u_max = 1, .v_min = -1, .v_max = 1, .cells_u = 100, .cells_v = 100},
                  [](double u, double v) { return Vec3d(u, v, 0.2 * u * v); }));
  const Chart chart = on.chart({.radius = radius}, bow(0));
  const ChartCheck check = check_chart(on.surface, on.picker, on.curve, chart, radius, Join::round);
  EXPECT_EQ(check.holes, 0U);
  EXPECT_FALSE(check.distances.has_value());
}

TEST(ChartCheck, CountsHolesOfAllJoins) {
  test::Charted on(test::plane(1, 0.02, 3));
  std::vector<Vec3d> corner = test::sampled(30, [](double s) { return Vec3d(0.7 * (s - 1), 0, 0); });
  for (const Vec3d& back : test::sampled(30, [](double s) { return Vec3d(-0.3 * s, 0.5 * s, 0); }))
    corner.push_back(back);
  for (const auto& [name, join] : named_joins) {
    Chart chart = on.chart({.radius = radius, .join = join}, corner);
    const ChartCheck right = check_chart(on.surface, on.picker, on.curve, chart, radius, join);
    EXPECT_GT(right.under_pen, 500U) << name;
    EXPECT_EQ(right.holes, 0U) << name;
    EXPECT_EQ(right.distances.has_value(), join == Join::round || join == Join::overlap) << name;
    const auto on_stroke = std::ranges::min_element(chart.d, {}, [](float d) { return std::abs(d); });
    const Index taken = chart.vertex[static_cast<std::size_t>(on_stroke - chart.d.begin())];
    std::ranges::replace(chart.vertex, taken, no_index);
    EXPECT_EQ(check_chart(on.surface, on.picker, on.curve, chart, radius, join).holes, 1U) << name;
  }
}

// Charts recordings of real pens by the command, on a flat sheet.
class RecordedStrokes : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Shared, RecordedStrokes,
                         testing::Values("bdalab_signal.svc", "bdalab_html5_pointer_signal.json",
                                         "painting30sec.dat"));

TEST_P(RecordedStrokes, HaveNoHolesAndTheRightDistances) {
  BURIN_SHARED_DATA_OR_SKIP(recording, std::string("strokes/") + GetParam());
  const test::CommandFolder folder;
  const std::string sheet =
      folder.write("sheet.obj", "v -1 -.75 0\nv 1 -.75 0\nv 1 .75 0\nv -1 .75 0\nf 1 2 3 4\n");
  const std::string strokes = folder.path("a.stroke");
  const test::ProcessResult imported =
      test::burin({"import", recording.string(), "--mesh", sheet, "--subdivide", "7", "--view", "0,0,-1",
                   "--out", strokes});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  const std::size_t count = std::min<std::size_t>(read_strokes(strokes).strokes.size(), 6);
  std::size_t vertices = 0, off_2 = 0;
  for (std::size_t stroke = 1; stroke <= count; ++stroke) {
    const test::ProcessResult charted =
        test::burin({"chart", strokes, "--stroke", std::to_string(stroke), "--mesh", sheet, "--subdivide",
                     "7", "--radius", "0.08", "--check", "--json"});
    ASSERT_EQ(charted.exit_code, 0) << charted.err;
    const auto check = nlohmann::json::parse(charted.out)["check"];
    EXPECT_EQ(check["holes"], 0) << "stroke " << stroke;
    EXPECT_EQ(check["distances"]["surface"], "plane");
    EXPECT_EQ(check["distances"]["off_by_10_percent"], 0) << "stroke " << stroke;
    vertices += check["under_pen"].get<std::size_t>();
    off_2 += check["distances"]["off_by_2_percent"].get<std::size_t>();
  }
  EXPECT_GT(vertices, 500U);
  // One in 10,000 is aimed at; a painter's scrubbing reaches three.
  EXPECT_LE(off_2, vertices / 1000 + 1) << off_2 << " of " << vertices;
}

TEST(ChartCheck, NeedsRoundEnds) {
  const test::CommandFolder folder;
  const test::ProcessResult result = test::burin(
      {"chart", folder.path("a.stroke"), "--mesh", folder.path("a.obj"), "--check", "--cap=butt"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("--check: needs round ends"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace burin::command
