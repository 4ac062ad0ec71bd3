#include <burin/base/error.h>
#include <burin/chart/chart_lookup.h>
#include <burin/chart/stroke_chart_builder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "chart/uniform.h"
#include "support/closed_curve.h"
#include "support/point_shapes.h"
#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

using test::sampled;

/// The chart of a stroke, round caps, and its lookup.
struct LookupScene {
  Surface surface;
  Picker picker;
  SurfaceCurve curve;
  Chart chart;
  ChartLookup lookup;

  LookupScene(TriangleMesh mesh, double radius, const std::vector<Vec3d>& samples, bool closed = false,
              int order = 2)
      : surface(make_surface(std::move(mesh))),
        picker(surface),
        curve(test::traced(surface, picker, radius, samples)),
        chart((closed ? test::close(curve) : void(),
               StrokeChartBuilder(surface).chart(curve, {radius, Cap::round, order}))),
        lookup(surface, chart) {}

  Vec3f vertex(std::size_t node) const { return surface.positions[chart.vertex[node]]; }
};

/// Every node that is the corner of a triangle is found at its own coordinates, on its own sheet.
void expect_nodes_found(const LookupScene& scene, double off) {
  std::vector<bool> corner(scene.chart.size(), false);
  for (const ChartTriangle& triangle : chart_triangles(scene.surface, scene.chart)) {
    for (const Index node : triangle.nodes) corner[node] = true;
  }
  EXPECT_GT(std::ranges::count(corner, true), 0.97 * static_cast<double>(scene.chart.size()));
  for (std::size_t i = 0; i < scene.chart.size(); ++i) {
    if (!corner[i]) continue;
    const auto place = scene.lookup.find(scene.chart.t[i], scene.chart.d[i], scene.chart.sheet[i]);
    ASSERT_TRUE(place.has_value()) << scene.chart.t[i] << " " << scene.chart.d[i];
    EXPECT_LE((place->at.position - scene.vertex(i)).norm(), off);
  }
}

LookupScene straight_on_plane() {
  return {test::shuffled(test::plane(1, 0.02, 7), 8), 0.2, {{-0.5, -0.31, 0}, {0.62, 0.27, 0}}};
}

TEST(ChartLookup, GoesBackFromStraightStrokesOnAPlaneExactly) {
  const LookupScene scene = straight_on_plane();
  const Vec3f from(-0.5F, -0.31F, 0), along = Vec3f(1.12F, 0.58F, 0).normalized();
  const Vec3f left(-along.y(), along.x(), 0);
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    const double t = (scene.curve.length() + 0.2) * test::uniform(random) - 0.1,
                 d = 0.28 * test::uniform(random) - 0.14;
    const auto place = scene.lookup.find(t, d);
    ASSERT_TRUE(place.has_value()) << t << " " << d;
    const Vec3f exact = from + static_cast<float>(t) * along + static_cast<float>(d) * left;
    EXPECT_LE((place->at.position - exact).norm(), 1e-5F);
    EXPECT_NEAR(place->t, t, 1e-6);
    EXPECT_NEAR(place->d, d, 1e-6);
    EXPECT_LE((place->e1 - along).norm() + (place->e2() - left).norm(), 1e-4F);
    EXPECT_NEAR(place->stretch, 1, 1e-5);
    const SurfacePoint& at = place->at;
    EXPECT_EQ(at.corners, scene.surface.triangles[at.triangle]);
    EXPECT_NEAR(at.weights[0] + at.weights[1] + at.weights[2], 1, 1e-6);
    EXPECT_GE(*std::ranges::min_element(at.weights), 0);
  }
  expect_nodes_found(scene, 1e-6);
}

TEST(ChartLookup, LosesNoPlaceBetweenTwoTriangles) {
  const LookupScene scene = straight_on_plane();
  std::size_t inner = 0;
  for (const ChartTriangle& triangle : chart_triangles(scene.surface, scene.chart)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      for (const double s : {0.1, 1. / 3, 0.5, 0.9}) {
        const double t = (1 - s) * triangle.t[i] + s * triangle.t[j];
        const double d = (1 - s) * static_cast<double>(scene.chart.d[triangle.nodes[i]]) +
                         s * static_cast<double>(scene.chart.d[triangle.nodes[j]]);
        EXPECT_TRUE(scene.lookup.find(t, d).has_value()) << t << " " << d;
        ++inner;
      }
    }
  }
  EXPECT_GT(inner, 10000U);
}

TEST(ChartLookup, FindsNothingOutside) {
  const LookupScene scene = straight_on_plane();
  const double length = scene.curve.length(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(scene.lookup.find(length / 2, 0).has_value());
  EXPECT_FALSE(scene.lookup.find(length / 2, 0.201).has_value());
  EXPECT_FALSE(scene.lookup.find(length / 2, -0.201).has_value());
  EXPECT_FALSE(scene.lookup.find(-0.201, 0).has_value());
  EXPECT_FALSE(scene.lookup.find(length + 0.201, 0).has_value());
  EXPECT_FALSE(scene.lookup.find(1e300, -1e300).has_value());
  EXPECT_FALSE(scene.lookup.find(length / 2, 0, 1).has_value());
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(scene.lookup.find(bad, 0).has_value());
    EXPECT_FALSE(scene.lookup.find(0, bad).has_value());
  }
  const auto corner = scene.picker.closest({1, -1, 0}, 0.1F);
  EXPECT_TRUE(scene.lookup.at(*corner).empty());
  EXPECT_FALSE(scene.lookup.field(*corner).has_value());
  EXPECT_TRUE(scene.lookup.at({}).empty());

  const Chart empty;
  const ChartLookup nothing(scene.surface, empty);
  EXPECT_FALSE(nothing.find(0, 0).has_value());
  EXPECT_TRUE(nothing.at(*corner).empty());
}

TEST(ChartLookup, RefusesTheChartOfAnotherSurface) {
  const LookupScene scene = straight_on_plane();
  EXPECT_THROW(ChartLookup(make_surface(test::plane(1, 0.5, 1)), scene.chart), ContractError);
}

/// Largest distance, in shares of the radius, between random (t, d) and the exact coordinates of the places
/// that are found there, along the equator of a sphere.
double error_on_sphere(int levels) {
  const double radius = 0.3, length = 2;
  const LookupScene scene(test::shuffled(test::sphere(levels, 0.15, 11), 12), radius,
                          sampled(120, [](double s) { return Vec3d(std::cos(2 * s), std::sin(2 * s), 0); }));
  std::mt19937 random(5);
  double largest = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.2 + (length - 0.4) * test::uniform(random), d = 0.4 * test::uniform(random) - 0.2;
    const auto place = scene.lookup.find(t, d);
    EXPECT_TRUE(place.has_value());
    if (!place) continue;
    const Vec3d x = place->at.position.cast<double>();
    const double exact_t = std::atan2(x.y(), x.x()), exact_d = std::asin(x.z() / x.norm());
    largest = std::max(largest, std::hypot(exact_t - t, exact_d - d) / radius);
  }
  expect_nodes_found(scene, 1e-6);
  return largest;
}

TEST(ChartLookup, ConvergesOnASphereWithTheSquareOfTheEdge) {
  const double coarse = error_on_sphere(4), middle = error_on_sphere(5), fine = error_on_sphere(6);
  std::cout << "largest error " << coarse << ", " << middle << ", " << fine << " radii\n";
  EXPECT_LE(middle, coarse / 3);
  EXPECT_LE(fine, middle / 3);
  EXPECT_LE(fine, 1e-3);
}

/// A helix up the cylinder of radius 1 by one for every turn of one radian; lines of constant d are helices.
LookupScene helix_on_cylinder() {
  return {test::shuffled(test::cylinder(1, 1.2, 0.03, 0.3, 5), 6), 0.3, sampled(90, [](double s) {
            const double angle = 1.4 * s - 0.7;
            return Vec3d(std::cos(angle), std::sin(angle), angle);
          })};
}

TEST(ChartLookup, GoesBackFromAHelix) {
  const LookupScene scene = helix_on_cylinder();
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    const double t = scene.curve.length() * test::uniform(random), d = 0.4 * test::uniform(random) - 0.2;
    const auto place = scene.lookup.find(t, d);
    ASSERT_TRUE(place.has_value()) << t << " " << d;
    const Vec3f& x = place->at.position;
    const double angle = std::atan2(static_cast<double>(x.y()), static_cast<double>(x.x())) + 0.7;
    const double up = static_cast<double>(x.z()) + 0.7;
    EXPECT_NEAR((angle + up) / std::numbers::sqrt2, t, 1e-3);
    EXPECT_NEAR((up - angle) / std::numbers::sqrt2, d, 1e-3);
  }
  expect_nodes_found(scene, 1e-6);
}

/// The field is orthonormal, tangent, and along `exact` at random places of the surface in the chart.
void expect_field(const LookupScene& scene, const std::function<Vec3d(const Vec3d&)>& exact, double angle) {
  std::mt19937 random(8);
  std::size_t held = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3f near = scene.vertex(random() % scene.chart.size()) +
                       0.02F * Vec3f(static_cast<float>(test::uniform(random)), 0,
                                     static_cast<float>(test::uniform(random)));
    const auto point = scene.picker.closest(near, 1);
    const auto place = scene.lookup.field(*point);
    if (!place) continue;
    EXPECT_NEAR(place->e1.norm(), 1, 1e-5);
    EXPECT_NEAR(place->e2().norm(), 1, 1e-5);
    EXPECT_NEAR(place->e1.dot(place->normal), 0, 1e-5);
    EXPECT_NEAR(place->e1.dot(place->e2()), 0, 1e-5);
    if (place->t < 0.1 || place->t > scene.curve.length() - 0.1) continue;
    const double sine = place->e1.cast<double>().cross(exact(place->at.position.cast<double>())).norm();
    EXPECT_LE(sine, std::sin(angle));
    EXPECT_GT(place->e1.cast<double>().dot(exact(place->at.position.cast<double>())), 0);
    ++held;
  }
  EXPECT_GT(held, 8000U);
}

TEST(ChartLookup, HasTheFieldOfAHelix) {
  expect_field(
      helix_on_cylinder(),
      [](const Vec3d& x) {
        const Vec3d around = Vec3d(-x.y(), x.x(), 0).normalized();
        return Vec3d((around + Vec3d::UnitZ()).normalized());
      },
      0.006);
}

TEST(ChartLookup, HasTheFieldOfAGreatCircle) {
  const LookupScene scene(test::shuffled(test::sphere(5, 0.15, 11), 12), 0.3,
                          sampled(120, [](double s) { return Vec3d(std::cos(2 * s), std::sin(2 * s), 0); }));
  expect_field(
      scene, [](const Vec3d& x) { return Vec3d(Vec3d(-x.y(), x.x(), 0).normalized()); }, 0.004);
}

// A stroke that runs from the left through the origin, around, and down through the origin.
LookupScene crossing_itself() {
  std::vector<Vec3d> samples = {{-0.7, 0, 0}, {-0.35, 0, 0}, {0, 0, 0}};
  for (int i = 0; i <= 18; ++i) {
    const double angle = std::numbers::pi * (-0.5 + i / 12.);
    samples.emplace_back(0.45 + 0.45 * std::cos(angle), 0.45 + 0.45 * std::sin(angle), 0);
  }
  samples.insert(samples.end(), {{0, 0.2, 0}, {0, 0, 0}, {0, -0.3, 0}, {0, -0.7, 0}});
  return {test::shuffled(test::plane(1, 0.02, 31), 32), 0.15, samples};
}

TEST(ChartLookup, HasBothSheetsOfACrossing) {
  const LookupScene scene = crossing_itself();
  const auto crossing = scene.picker.closest(Vec3f::Zero(), 0.1F);
  const auto places = scene.lookup.at(*crossing);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_LT(places[0].t, places[1].t);
  EXPECT_NEAR(places[0].t, 0.7, 0.02);
  EXPECT_LE((places[0].e1 - Vec3f::UnitX()).norm(), 0.05F);
  EXPECT_LE((places[1].e1 + Vec3f::UnitY()).norm(), 0.05F);
  for (std::uint32_t sheet = 0; sheet < 2; ++sheet) {
    const ChartPoint& place = places[sheet];
    EXPECT_EQ(place.sheet, sheet);
    EXPECT_NEAR(place.d, 0, 0.01);
    for (const auto& asked : {std::optional<std::uint32_t>(), std::optional(sheet)}) {
      const auto found = scene.lookup.find(place.t, place.d, asked);
      ASSERT_TRUE(found.has_value());
      EXPECT_LE((found->at.position - crossing->position).norm(), 1e-5F);
      EXPECT_EQ(found->sheet, sheet);
      EXPECT_LE((found->e1 - place.e1).norm(), 1e-4F);
    }
    EXPECT_FALSE(scene.lookup.find(place.t, place.d, 1 - sheet).has_value());
  }
  // The field beside the crossing is that of the nearer visit.
  EXPECT_GT(scene.lookup.field(*scene.picker.closest({0.05F, 0.01F, 0}, 1))->e1.x(), 0.9F);
  EXPECT_LT(scene.lookup.field(*scene.picker.closest({0.01F, 0.05F, 0}, 1))->e1.y(), -0.9F);
  expect_nodes_found(scene, 1e-6);
}

TEST(ChartLookup, GoesAcrossTheSeamOfAClosedStroke) {
  const LookupScene scene(test::shuffled(test::cylinder(1, 1, 0.04, 0.3, 5), 6), 0.3,
                          sampled(80,
                                  [](double s) {
                                    const double angle = 2 * std::numbers::pi * s;
                                    return Vec3d(std::cos(angle), std::sin(angle), 0);
                                  }),
                          true);
  const double length = scene.chart.length;
  ASSERT_TRUE(scene.chart.closed);
  ASSERT_NEAR(length, 2 * std::numbers::pi, 2e-3);
  for (const double d : {-0.2, 0., 0.13}) {
    for (double t : {-0.05, -0.01, -1e-9, -0., 1e-9, 0.003, 0.05}) {
      for (const double turns : {0., 1., -3.}) {
        const auto place = scene.lookup.find(t + turns * length, d);
        ASSERT_TRUE(place.has_value()) << t << " " << d;
        EXPECT_TRUE(place->t >= 0 && place->t < length);
        EXPECT_NEAR(std::remainder(place->t - t, length), 0, 1e-6);
        const Vec3f& x = place->at.position;
        EXPECT_NEAR(std::atan2(x.y(), x.x()), t, 2e-3);
        EXPECT_NEAR(x.z(), d, 2e-3);
        const auto back = scene.lookup.at(place->at);
        ASSERT_EQ(back.size(), 1U);
        EXPECT_EQ(back[0].t, place->t);
      }
    }
  }
  expect_nodes_found(scene, 1e-6);
}

// The stroke goes to the right along y = 0.12 and back along y = -0.12. Inside the bend the coordinates of
// the two sides end where these meet.
TEST(ChartLookup, EndsWhereTheRunsOfATightBendMeet) {
  for (const int order : {1, 2}) {
    const LookupScene scene(test::shuffled(test::plane(1, 0.02, 31), 32), 0.25,
                            {{-0.6, 0.12, 0},
                             {0, 0.12, 0},
                             {0.4, 0.12, 0},
                             {0.52, 0, 0},
                             {0.4, -0.12, 0},
                             {0, -0.12, 0},
                             {-0.6, -0.12, 0}},
                            false, order);
    std::mt19937 random(9);
    std::size_t found = 0, outer = 0;
    for (int i = 0; i < 6000; ++i) {
      const double t = scene.curve.length() * test::uniform(random), d = 0.42 * test::uniform(random) - 0.21;
      const auto place = scene.lookup.find(t, d);
      outer += d > 0;
      EXPECT_TRUE(place.has_value() || d < 0) << t << " " << d;
      if (!place) continue;
      ++found;
      EXPECT_NEAR(place->t, t, 1e-5);
      EXPECT_NEAR(place->d, d, 1e-5);
      double nearest = 1;
      for (const CurvePoint& point : scene.curve.points) {
        if (std::abs(point.t - t) > 0.2) continue;
        nearest = std::min(nearest, static_cast<double>((point.at.position - place->at.position).norm()));
      }
      EXPECT_NEAR(nearest, std::abs(d), 0.02) << t << " " << d;
      EXPECT_TRUE(std::ranges::any_of(scene.lookup.at(place->at), [&](const ChartPoint& back) {
        return std::hypot(back.t - t, back.d - d) < 1e-5;
      }));
    }
    EXPECT_GT(outer, 2500U);
    EXPECT_GT(found, 5000U);
    EXPECT_LT(found, 5950U);
    const double bend = scene.curve.length() / 2;
    EXPECT_FALSE(scene.lookup.find(bend, -0.22).has_value());
  }
}

// Two triangles above each other hold the same (t, d), one of them in a mirror.
TEST(ChartLookup, PrefersPlacesThatTheChartDoesNotMirror) {
  const Surface surface = make_surface(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 9}, {1, 0, 9}, {0, 1, 9}}, {{0, 1, 2}, {3, 4, 5}}});
  for (const bool mirror_lower : {false, true}) {
    Chart chart;
    for (Index vertex = 0; vertex < 6; ++vertex) {
      const Vec3f& x = surface.positions[vertex];
      const bool mirrored = (x.z() == 0) == mirror_lower;
      chart.vertex.push_back(vertex);
      chart.sheet.push_back(0);
      chart.t.push_back(static_cast<double>(mirrored ? x.y() : x.x()));
      chart.d.push_back(mirrored ? x.x() : x.y());
      chart.e1.push_back(mirrored ? Vec3f::UnitY() : Vec3f::UnitX());
      chart.normal.push_back(Vec3f::UnitZ());
      chart.stretch.push_back(1);
    }
    const auto place = ChartLookup(surface, chart).find(0.2, 0.3);
    ASSERT_TRUE(place.has_value());
    EXPECT_LE((place->at.position - Vec3f(0.2F, 0.3F, mirror_lower ? 9 : 0)).norm(), 1e-5F);
  }
}

TEST(ChartLookup, KnowsWhereAPointOfAPointSetIs) {
  const Surface surface = make_point_surface(test::plane_points(1, 0.04, 51));
  const Picker picker(surface);
  const SurfaceCurve curve = test::traced(surface, picker, 0.3, {{-0.5, 0.1, 0}, {0.5, 0.1, 0}});
  const Chart chart = StrokeChartBuilder(surface).chart(curve, {0.3, Cap::butt});
  const ChartLookup lookup(surface, chart);
  EXPECT_THROW(lookup.find(0.5, 0), ContractError);
  const auto places = lookup.at(*picker.closest({0.123F, 0.234F, 0}, 0.1F));
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0].t, 0.623, 1e-3);
  EXPECT_NEAR(places[0].d, 0.134, 1e-3);
}

}  // namespace
}  // namespace burin
