// Strokes across meshes that are no manifolds, torn, folded, degenerate: charts stay finite and bounded.
#include <burin/chart/stroke_chart.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "support/shared_data.h"

namespace burin {
namespace {

class NastyMesh : public testing::TestWithParam<const char*> {};

/// A point of a random triangle.
Vec3f random_place(const Surface& surface, std::mt19937& random) {
  const Triangle& c = surface.triangles[random() % surface.triangles.size()];
  const float u = static_cast<float>(random() % 1000) / 2000, v = static_cast<float>(random() % 1000) / 2000;
  return (1 - u - v) * surface.positions[c[0]] + u * surface.positions[c[1]] + v * surface.positions[c[2]];
}

SurfaceCurve random_stroke(const Surface& surface, const Picker& picker, double radius,
                           std::mt19937& random) {
  CurveTracer tracer(surface, picker, radius);
  Vec3f place = random_place(surface, random);
  const Vec3f heading = (random_place(surface, random) - place).normalized();
  for (std::size_t samples = 1 + random() % 12; samples > 0; --samples) {
    const auto at = picker.closest(place, static_cast<float>(4 * radius));
    if (at && (tracer.curve().points.empty() || tracer.connects(*at))) tracer.add(*at, 0, {});
    const Vec3f wobble =
        0.5F * Vec3f(static_cast<float>(random() % 3) - 1, static_cast<float>(random() % 3) - 1,
                     static_cast<float>(random() % 3) - 1);
    place += static_cast<float>(radius) * (heading + wobble);
  }
  return tracer.curve();
}

void expect_finite_and_within(const Chart& chart, double radius) {
  for (std::size_t i = 0; i < chart.size(); ++i) {
    ASSERT_TRUE(std::isfinite(chart.t[i]));
    ASSERT_LE(std::abs(chart.d[i]), radius * 1.000001);
    ASSERT_NEAR(chart.e1[i].norm(), 1, 1e-4);
    if (i == 0) continue;
    const bool same = chart.vertex[i - 1] == chart.vertex[i];
    ASSERT_LE(chart.vertex[i - 1], chart.vertex[i]);
    ASSERT_EQ(chart.sheet[i], same ? chart.sheet[i - 1] + 1 : 0);
    ASSERT_TRUE(!same || chart.t[i - 1] < chart.t[i]);
  }
}

TEST_P(NastyMesh, StandsRandomStrokes) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/nasty/") + GetParam());
  const Surface surface = make_surface(triangulate(read_mesh(file)));
  const Picker picker(surface);
  StrokeCharter charter(surface);
  const std::uint32_t seed = 2024;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t charted = 0, long_strokes = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = surface.scale * 0.01 * static_cast<double>(1 + random() % 30);
    const SurfaceCurve curve = random_stroke(surface, picker, radius, random);
    ASSERT_FALSE(curve.points.empty());
    for (const CurvePoint& point : curve.points) {
      ASSERT_TRUE(point.at.position.allFinite() && point.tangent.allFinite() && std::isfinite(point.t));
    }
    const Chart chart = charter.chart(curve, {radius, i % 2 == 0 ? Cap::round : Cap::butt});
    expect_finite_and_within(chart, radius);
    charted += chart.size() > 0;
    long_strokes += curve.length() > 2 * radius;
  }
  EXPECT_GT(charted, 20U);
  EXPECT_GT(long_strokes, 10U);
}

INSTANTIATE_TEST_SUITE_P(Shared, NastyMesh,
                         testing::Values("capsule.obj", "dragon_vrip_res3.ply", "fan3.obj",
                                         "hourglass_ico.obj", "moebius.obj", "not_convex.obj", "soup.stl"),
                         [](const auto& mesh) {
                           const std::string name = mesh.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace burin
