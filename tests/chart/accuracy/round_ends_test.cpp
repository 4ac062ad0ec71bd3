// Compares coordinates beyond round ends, where (t, d) are geodesic normal coordinates around the end,
// with the logarithmic maps of sphere and cylinder, and with geodesics shot from the end on height fields.
// Errors are in percent of the radius.
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <optional>
#include <vector>

#include "shooting_errors.h"
#include "support/charted.h"
#include "support/drawn_strokes.h"
#include "support/shapes.h"

namespace burin {
namespace {

/// The direction and length of the geodesic from p to x, as a vector in the tangent plane of p, where the
/// surface has this normal.
using Logarithm = std::function<std::optional<Vec3d>(const Vec3d& p, const Vec3d& normal, const Vec3d& x)>;

std::optional<Vec3d> on_sphere(const Vec3d& p, const Vec3d&, const Vec3d& x) {
  const Vec3d from = p.normalized(), to = x.normalized(), flat = to - from.dot(to) * from;
  return std::atan2(flat.norm(), from.dot(to)) * flat.normalized();
}

/// The logarithmic map of the cylinder of radius 1 about the z axis.
std::optional<Vec3d> on_cylinder(const Vec3d& p, const Vec3d&, const Vec3d& x) {
  const Vec3d around(-p.y(), p.x(), 0);
  return std::atan2(p.x() * x.y() - p.y() * x.x(), p.x() * x.x() + p.y() * x.y()) * around.normalized() +
         (x.z() - p.z()) * Vec3d::UnitZ();
}

/// Geodesics at right angles to a tiny circle around p.
Logarithm on_height_field(test::HeightField field) {
  return [field](const Vec3d& p, const Vec3d&, const Vec3d& x) -> std::optional<Vec3d> {
    constexpr double tiny = 1e-4;
    const test::Height at = field(p.x(), p.y());
    const Vec3d normal = Vec3d(-at.fx, -at.fy, 1).normalized();
    const Vec3d a = Vec3d(1, 0, at.fx).normalized(), b = normal.cross(a);
    const auto direction = [=](double angle) { return Vec3d(std::cos(angle) * a + std::sin(angle) * b); };
    const Vec3d way = x - p;
    const double start = std::atan2(way.dot(b), way.dot(a)) - std::numbers::pi;
    const auto angle = [start](double s) { return start + 2 * std::numbers::pi * s; };
    const test::ShootingOracle oracle(
        field, {[=](double s) { return Vec2d(p.head<2>() + tiny * direction(angle(s)).head<2>()); },
                [=](double s) {
                  return Vec2d(2 * std::numbers::pi * tiny *
                               (-std::sin(angle(s)) * a + std::cos(angle(s)) * b).head<2>());
                }});
    const auto found = oracle.solve(x.head<2>(), {oracle.length() / 2, tiny - way.norm()});
    if (!found) return std::nullopt;
    return (tiny - found->d) * direction(angle(found->t / oracle.length()));
  };
}

struct Case {
  const char* name;
  std::function<TriangleMesh()> mesh;
  std::function<Vec3d(double)> stroke;  ///< s in [0, 1]
  Logarithm logarithm;
  double radius, follow;
  double mean, most;       ///< error of t and d allowed, percent of the radius
  std::size_t stride = 1;  ///< every so many nodes are looked at
};
std::ostream& operator<<(std::ostream& out, const Case& scene) { return out << scene.name; }

class RoundEnds : public testing::TestWithParam<Case> {};

TEST_P(RoundEnds, HaveNormalCoordinatesAroundTheEnd) {
  const Case& scene = GetParam();
  test::Charted on(scene.mesh());
  std::vector<Vec3d> samples;
  for (int i = 0; i < 100; ++i) samples.push_back(scene.stroke(i / 99.));
  const Chart chart = on.chart({.radius = scene.radius, .follow = scene.follow}, samples);
  std::vector<double> errors_t, errors_d;
  for (std::size_t i = 0; i < chart.size(); i += scene.stride) {
    const bool begin = chart.t[i] < 0;
    if (!begin && chart.t[i] <= chart.length) continue;
    const CurvePoint& end = begin ? on.curve.points.front() : on.curve.points.back();
    const Vec3d normal = end.normal.cast<double>(), along = end.tangent.cast<double>();
    const auto way = scene.logarithm(end.at.position.cast<double>(), normal,
                                     on.surface.positions[chart.vertex[i]].cast<double>());
    ASSERT_TRUE(way.has_value());
    const double t = (begin ? 0 : chart.length) + way->dot(along), d = way->dot(normal.cross(along));
    errors_t.push_back(100 / scene.radius * std::abs(chart.t[i] - t));
    errors_d.push_back(100 / scene.radius * std::abs(static_cast<double>(chart.d[i]) - d));
  }
  ASSERT_GT(errors_t.size(), 200U);
  for (const auto& [errors, name] : {std::pair(errors_t, "t"), std::pair(errors_d, "d")}) {
    double mean = 0;
    for (const double error : errors) mean += error / static_cast<double>(errors.size());
    const double most = *std::ranges::max_element(errors);
    std::cout << name << " mean " << mean << " max " << most << " of " << errors.size() << "\n";
    EXPECT_LE(mean, scene.mean) << name;
    EXPECT_LE(most, scene.most) << name;
  }
}

Vec3d along_great_circle(double s) { return {std::sin(0.6 * (s - 0.5)), 0, std::cos(0.6 * (s - 0.5))}; }
Vec3d around_pole(double s) { return Vec3d(0.6 * std::cos(3 * s), 0.6 * std::sin(3 * s), 0.8); }
Vec3d up_a_cylinder(double s) { return {std::cos(0.2 * s * s), std::sin(0.2 * s * s), 0.6 * (s - 0.5)}; }
TriangleMesh half_sphere(double edge) { return test::exact_sphere()->mesh(edge, 1.4, 5); }

std::function<Vec3d(double)> over(test::HeightField field) {
  const test::PlaneCurve curve = test::s_curve();
  return [=](double s) {
    const Vec2d at = curve.place(0.2 + 0.6 * s);
    return Vec3d(at.x(), at.y(), field(at.x(), at.y()).f);
  };
}

TriangleMesh round_cylinder() { return test::shuffled(test::cylinder(1, 1.3, 0.02, 0.3, 5), 6); }

/// `follow` 1 is the surface itself, 0 the base surface, from which the coordinates are carried over.
Case on_great_circle(const char* name, double follow, double mean, double most) {
  return {name, [] { return half_sphere(0.045); }, &along_great_circle, &on_sphere, 0.9, follow, mean, most};
}

Case on_field(const char* name, test::Height (*field)(double, double), double follow, double mean,
              double most) {
  constexpr int cells = 173;  // 20 edges in the radius
  return {name,
          [=] { return test::field_mesh(field, cells); },
          over(field),
          on_height_field(field),
          0.3,
          follow,
          mean,
          most,
          5};
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, RoundEnds,
    testing::Values(on_great_circle("GreatCircle", 1, 0.01, 0.1),
                    on_great_circle("GreatCircleFromTheBase", 0, 0.06, 0.5),
                    Case{"SmallCircle", [] { return half_sphere(0.02); }, &around_pole, &on_sphere, 0.4, 1,
                         0.02, 0.4},
                    Case{"Cylinder", &round_cylinder, &up_a_cylinder, &on_cylinder, 0.4, 1, 0.02, 0.4},
                    on_field("EggCrate", &test::shallow_egg_crate, 1, 0.01, 0.15),
                    on_field("HillOnSaddle", &test::hill_on_saddle, 1, 0.01, 0.15),
                    on_field("HillOnSaddleFromTheBase", &test::hill_on_saddle, 0, 0.03, 0.5)),
    [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace burin
