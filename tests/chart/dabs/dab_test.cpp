#include <burin/base/error.h>
#include <burin/chart/dabs/dab.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/picker.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

constexpr DabMethod every_method[] = {DabMethod::dem, DabMethod::dem_upwind, DabMethod::frame_propagation};

struct Scene {
  Surface surface;
  Picker picker;
  DabChartBuilder builder;

  explicit Scene(TriangleMesh mesh)
      : surface(make_surface(std::move(mesh))), picker(surface), builder(surface) {}

  SurfacePoint at(const Vec3d& position) const { return picker.closest(position.cast<float>(), 1).value(); }
  Vec3d place(Index vertex) const { return surface.positions[vertex].cast<double>(); }
};

using Coordinates = Eigen::Vector2d;

/// |(u, v) - truth| in shares of the radius.
struct DabError {
  double mean = 0, max = 0;
  std::size_t count = 0;
};

/// `exact` gives (u, v) of a vertex of the surface, or nothing where it is not to be judged.
template <class Exact>
DabError error_against(const DabChart& chart, double radius, const Exact& exact) {
  DabError error;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const std::optional<Coordinates> truth = exact(chart.vertex[i]);
    if (!truth) continue;
    const double e = (Coordinates(chart.u[i], chart.v[i]) - *truth).norm() / radius;
    error.mean += e;
    error.max = std::max(error.max, e);
    ++error.count;
  }
  error.mean /= static_cast<double>(error.count);
  std::cout << "error mean " << 100 * error.mean << " max " << 100 * error.max << " % of the radius, "
            << error.count << " vertices\n";
  return error;
}

void expect_exact_on_plane(Scene& scene, const SurfacePoint& centre, DabMethod method) {
  const double radius = 0.3;
  const Vec3d middle = centre.position.cast<double>(), along = Vec3d(3, 1, 0).normalized();
  const Vec3d left(-along.y(), along.x(), 0);
  const DabChart chart = scene.builder.chart(centre, {3, 1, 0.5}, {radius, method});
  const DabError error = error_against(chart, radius, [&](Index vertex) -> std::optional<Coordinates> {
    const Vec3d away = scene.place(vertex) - middle;
    return Coordinates(away.dot(along), away.dot(left));
  });
  EXPECT_GT(error.count, 2500U);
  EXPECT_LE(error.max, 1e-5);
  for (const Vec3f& e1 : chart.e1) ASSERT_LT((e1 - along.cast<float>()).norm(), 1e-5F);
}

TEST(Dab, IsExactOnAPlane) {
  Scene scene(test::shuffled(test::plane(1, 0.01, 7), 8));
  const auto near_middle = [](const Vec3f& x) { return x.norm() < 0.1F; };
  const auto inner_vertex = static_cast<Index>(std::ranges::find_if(scene.surface.positions, near_middle) -
                                               scene.surface.positions.begin());
  for (const DabMethod method : every_method) {
    expect_exact_on_plane(scene, scene.at({0.123, -0.2, 0}), method);
    expect_exact_on_plane(scene, scene.at(scene.place(inner_vertex)), method);
  }
}

TEST(Dab, HoldsExactlyTheDiscOnAPlane) {
  Scene scene(test::plane(1, 0.02, 3));
  const double radius = 0.25, slack = 1e-5;
  const SurfacePoint centre = scene.at({0.01, 0.313, 0});
  for (const DabMethod method : every_method) {
    const DabChart chart = scene.builder.chart(centre, Vec3f::UnitX(), {radius, method});
    std::vector<bool> held(scene.surface.vertex_count(), false);
    for (const Index v : chart.vertex) held[v] = true;
    for (Index v = 0; v < scene.surface.vertex_count(); ++v) {
      const double outside =
          static_cast<double>((scene.surface.positions[v] - centre.position).norm()) - radius;
      if (std::abs(outside) <= slack) continue;
      EXPECT_EQ(held[v], outside < 0);
    }
  }
}

/// The log map of the unit sphere.
Coordinates sphere_log(const Vec3d& p, const Vec3d& e1, const Vec3d& x) {
  const Vec3d away = x - p.dot(x) * p;
  const double angle = std::atan2(away.norm(), p.dot(x));
  return angle / away.norm() * Coordinates(away.dot(e1), away.dot(p.cross(e1)));
}

// The minimal rotation between normals of a sphere is parallel transport along the great circle: there the
// DEM's frames are exact, and frame propagation has no advantage to show.
TEST(Dab, ApproximatesTheLogMapOfTheSphere) {
  Scene scene(test::shuffled(test::sphere(6, 0.15, 11), 12));
  const double radius = 0.8;
  const SurfacePoint centre = scene.at(Vec3d(0.3, -0.5, 0.6).normalized());
  const Vec3d p = centre.position.cast<double>().normalized(), e1 = p.unitOrthogonal();
  for (const DabMethod method : every_method) {
    const DabChart chart = scene.builder.chart(centre, e1.cast<float>(), {radius, method});
    const DabError error = error_against(chart, radius, [&](Index vertex) -> std::optional<Coordinates> {
      return sphere_log(p, e1, scene.place(vertex).normalized());
    });
    EXPECT_GT(error.count, 5000U);
    EXPECT_LE(error.mean, 0.004);
    EXPECT_LE(error.max, 0.025);
    for (std::size_t i = 0; i < chart.size(); ++i) {
      const Vec3d x = scene.place(chart.vertex[i]).normalized();
      const Vec3d transported = e1 - x.dot(e1) / (1 + p.dot(x)) * (p + x);
      ASSERT_LT((chart.e1[i].cast<double>() - transported).norm(), 0.05);
    }
  }
}

/// The quadric surface k . (x^2, y^2, z^2) = 1 and its exponential map at a point p.
struct Quadric {
  Vec3d k, p, e1, e2;

  Quadric(const Vec3d& coefficients, const Vec3d& towards) : k(coefficients) {
    p = towards / std::sqrt(towards.cwiseAbs2().dot(k));
    const Vec3d normal = k.cwiseProduct(p).normalized();
    e1 = normal.unitOrthogonal();
    e2 = normal.cross(e1);
  }

  /// x'' of a geodesic: at right angles to the surface, so that its second derivative along x is 0.
  Vec3d acceleration(const Vec3d& x, const Vec3d& velocity) const {
    const Vec3d gradient = k.cwiseProduct(x);
    return -velocity.cwiseAbs2().dot(k) / gradient.squaredNorm() * gradient;
  }

  /// The exponential map, by the classical Runge-Kutta method.
  Vec3d exp(double u, double v) const {
    constexpr int steps = 64;
    constexpr double h = 1. / steps;
    Vec3d x = p, velocity = u * e1 + v * e2;
    for (int i = 0; i < steps; ++i) {
      const Vec3d a1 = acceleration(x, velocity), v2 = velocity + h / 2 * a1;
      const Vec3d a2 = acceleration(x + h / 2 * velocity, v2), v3 = velocity + h / 2 * a2;
      const Vec3d a3 = acceleration(x + h / 2 * v2, v3), v4 = velocity + h * a3;
      const Vec3d a4 = acceleration(x + h * v3, v4);
      x += h / 6 * (velocity + 2 * v2 + 2 * v3 + v4);
      velocity += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return x;
  }
};

/// A mesh whose vertices stand at exp of the plane's: their normal coordinates are known.
void expect_close_on_quadric(const Quadric& quadric) {
  const double radius = 0.6;
  const TriangleMesh coordinates = test::shuffled(test::plane(1, 0.02, 3), 4);
  TriangleMesh mesh = coordinates;
  for (Vec3f& x : mesh.positions) x = quadric.exp(x.x(), x.y()).cast<float>();
  Scene scene(mesh);
  for (const DabMethod method : every_method) {
    const DabChart chart =
        scene.builder.chart(scene.at(quadric.p), quadric.e1.cast<float>(), {radius, method});
    const DabError error = error_against(chart, radius, [&](Index vertex) -> std::optional<Coordinates> {
      return coordinates.positions[scene.surface.source_vertex[vertex]].head<2>().cast<double>();
    });
    EXPECT_GT(error.count, 2500U);
    EXPECT_LE(error.mean, 0.005);
    EXPECT_LE(error.max, 0.05);
  }
}

TEST(Dab, ApproximatesTheLogMapWhereCurvatureVaries) {
  expect_close_on_quadric({{1, 2, 4}, {0.9, 0.5, 0.35}});     // an ellipsoid
  expect_close_on_quadric({{1, 1.5, -1}, {0.9, 0.5, 0.35}});  // a hyperboloid: negative curvature
}

/// The cone about the z axis with its apex, a vertex, at 0.
TriangleMesh cone(double half_angle, double edge, std::uint32_t seed) {
  TriangleMesh mesh = test::plane(1, edge, seed);
  *std::ranges::min_element(mesh.positions, {}, [](const Vec3f& x) { return x.norm(); }) = Vec3f::Zero();
  for (Vec3f& x : mesh.positions) {
    const Vec3d flat = x.cast<double>() * std::sin(half_angle);
    x = Vec3d(flat.x(), flat.y(), -flat.norm() / std::tan(half_angle)).cast<float>();
  }
  return mesh;
}

// Figure 5 of the paper. The cone unrolled about its apex is a sector, in which all geodesics from the centre
// are straight; the cut lies behind the apex.
TEST(Dab, PropagatesFramesRightAroundTheApexOfACone) {
  const double half_angle = 0.7, turned = std::sin(half_angle), radius = 0.5, pi = std::numbers::pi;
  Scene scene(test::shuffled(cone(half_angle, 0.01, 5), 6));
  const SurfacePoint centre = scene.at(0.2 * Vec3d(std::sin(half_angle), 0, -std::cos(half_angle)));
  const double to_apex = centre.position.cast<double>().norm();
  const double azimuth = std::atan2(centre.position.y(), centre.position.x());
  const auto unrolled = [&](Index vertex) -> std::optional<Coordinates> {
    const Vec3d x = scene.place(vertex);
    const double around = std::remainder(std::atan2(x.y(), x.x()) - azimuth, 2 * pi);
    if (std::abs(around) > pi - 0.4) return std::nullopt;
    return Coordinates(x.norm() * std::cos(turned * around) - to_apex, x.norm() * std::sin(turned * around));
  };
  const auto error = [&](DabMethod method) {
    return error_against(scene.builder.chart(centre, centre.position, {radius, method}), radius, unrolled);
  };
  const DabError propagated = error(DabMethod::frame_propagation);
  EXPECT_GT(propagated.count, 8000U);
  EXPECT_LE(propagated.mean, 0.0005);
  EXPECT_LE(propagated.max, 0.03);
  for (const DabMethod method : {DabMethod::dem, DabMethod::dem_upwind}) {
    const DabError linked = error(method);
    EXPECT_GE(linked.mean, 0.02);
    EXPECT_GE(linked.max, 0.25);
  }
}

/// A point of the profile of a horn that stands on the plane z = 0, `s` along it from the tip: a round cap, a
/// straight shaft, a fillet, the plane.
struct HornProfile {
  double width, shaft, fillet;

  /// (distance from the axis, height).
  Eigen::Vector2d at(double s) const {
    constexpr double quarter = std::numbers::pi / 2;
    const double cap_end = width * quarter, shaft_end = cap_end + shaft, end = shaft_end + fillet * quarter;
    const double height = shaft + fillet;
    if (s < cap_end) return {width * std::sin(s / width), height + width * std::cos(s / width)};
    if (s < shaft_end) return {width, height - (s - cap_end)};
    if (s > end) return {width + fillet + s - end, 0};
    const double angle = (s - shaft_end) / fillet;
    return {width + fillet * (1 - std::cos(angle)), fillet * (1 - std::sin(angle))};
  }
};

/// A horn about the z axis, bent towards +x.
TriangleMesh horn(double edge, std::uint32_t seed) {
  TriangleMesh mesh = test::plane(2, edge, seed);
  const HornProfile profile{0.15, 0.5, 0.1};
  for (Vec3f& x : mesh.positions) {
    const Vec3d from = x.cast<double>();
    const Eigen::Vector2d to = profile.at(from.norm());
    const double stretch = from.norm() > 0 ? to.x() / from.norm() : 1;
    x = Vec3d(stretch * from.x() + 0.5 * to.y() * to.y(), stretch * from.y(), to.y()).cast<float>();
  }
  return mesh;
}

struct HornMap {
  double collapsed =
      0;  ///< share of the horn's triangles charted with less than 1/4 of their area, or flipped
  std::size_t torn =
      0;  ///< triangles on the ground behind it with an edge charted four times as long as it is
};

HornMap measure(const Surface& surface, const DabChart& chart) {
  std::vector<std::optional<Vec2f>> at(surface.vertex_count());
  for (std::size_t i = 0; i < chart.size(); ++i) at[chart.vertex[i]] = Vec2f(chart.u[i], chart.v[i]);
  HornMap map;
  std::size_t on_horn = 0, behind = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    if (!at[a] || !at[b] || !at[c]) continue;
    const Vec3f &x = surface.positions[a], &y = surface.positions[b], &z = surface.positions[c];
    const Vec2f ab = *at[b] - *at[a], ac = *at[c] - *at[a];
    const Vec3f middle = (x + y + z) / 3;
    if (middle.z() > 0.05F) {
      ++on_horn;
      map.collapsed += ab.x() * ac.y() - ab.y() * ac.x() < (y - x).cross(z - x).norm() / 4;
    } else if (middle.x() > 0.3F && std::abs(middle.y()) < 0.3F) {
      ++behind;
      map.torn += ab.norm() > 4 * (y - x).norm() || ac.norm() > 4 * (z - x).norm();
    }
  }
  map.collapsed /= static_cast<double>(on_horn);
  std::cout << 100 * map.collapsed << " % of the horn collapsed, " << map.torn << " of " << behind
            << " triangles torn behind\n";
  return map;
}

// Figure 6 of the paper.
TEST(Dab, WrapsAroundAHornOrCollapsesIt) {
  Scene scene(test::shuffled(horn(0.02, 5), 6));
  const SurfacePoint centre = scene.at({-0.45, 0, 0});
  const auto map = [&](DabMethod method) {
    return measure(scene.surface, scene.builder.chart(centre, Vec3f::UnitX(), {1, method}));
  };
  const HornMap propagated = map(DabMethod::frame_propagation), linked = map(DabMethod::dem_upwind);
  EXPECT_GE(propagated.torn, 20U);
  EXPECT_EQ(linked.torn, 0U);
  EXPECT_LE(propagated.collapsed, 0.2);
  EXPECT_GE(linked.collapsed, 0.4);
  EXPECT_GE(map(DabMethod::dem).collapsed, 0.3);
}

void expect_finite_and_within(const DabChart& chart, double radius) {
  for (std::size_t i = 0; i < chart.size(); ++i) {
    ASSERT_LE(static_cast<double>(std::hypot(chart.u[i], chart.v[i])), radius * 1.000001);
    ASSERT_NEAR(chart.e1[i].norm(), 1, 1e-4);
    ASSERT_TRUE(i == 0 || chart.vertex[i - 1] < chart.vertex[i]);
  }
}

TEST(Dab, CoversAClosedMeshSmallerThanItself) {
  Scene scene(test::sphere(4, 0.2, 2));
  for (const DabMethod method : every_method) {
    const DabChart chart = scene.builder.chart(scene.at(Vec3d::UnitZ()), Vec3f::UnitX(), {10, method});
    EXPECT_EQ(chart.size(), scene.surface.vertex_count());
    expect_finite_and_within(chart, 10);
  }
}

void expect_same(const DabChart& a, const DabChart& b) {
  EXPECT_EQ(a.vertex, b.vertex);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.e1, b.e1);
}

TEST(Dab, DependsOnNothingButItsArguments) {
  Scene scene(test::sphere(5, 0.2, 21));
  for (const DabMethod method : every_method) {
    const SurfacePoint centre = scene.at(Vec3d::UnitZ());
    const DabChart before = scene.builder.chart(centre, Vec3f::UnitX(), {0.3, method});
    EXPECT_GT(before.size(), 100U);
    scene.builder.chart(scene.at(Vec3d(1, 0, 1).normalized()), Vec3f::UnitY(), {0.5, DabMethod::dem});
    expect_same(before, scene.builder.chart(centre, Vec3f::UnitX(), {0.3, method}));
    expect_same(before, DabChartBuilder(scene.surface).chart(centre, Vec3f::UnitX(), {0.3, method}));
  }
}

TEST(Dab, RefusesWhatIsNoDab) {
  Scene scene(test::plane(1, 0.5, 1));
  const SurfacePoint centre = scene.at({0, 0, 0});
  const Vec3f along = Vec3f::UnitX();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(scene.builder.chart(centre, along, {0}), ContractError);
  EXPECT_THROW(scene.builder.chart(centre, along, {infinity}), ContractError);
  EXPECT_THROW(scene.builder.chart(centre, Vec3f::Zero(), {1}), ContractError);
  EXPECT_THROW(scene.builder.chart(centre, {nan, 0, 0}, {1}), ContractError);
  EXPECT_THROW(scene.builder.chart({}, along, {1}), ContractError);
  expect_finite_and_within(scene.builder.chart(centre, Vec3f::UnitZ(), {1}), 1);
}

class NastyDab : public testing::TestWithParam<const char*> {};

TEST_P(NastyDab, StaysFiniteAndBounded) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/nasty/") + GetParam());
  Scene scene(triangulate(read_mesh(file)));
  const std::uint32_t seed = 2025;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t charted = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = scene.surface.scale * 0.01 * static_cast<double>(1 + random() % 100);
    const Triangle& triangle = scene.surface.triangles[random() % scene.surface.triangles.size()];
    const Vec3d place = (scene.place(triangle[0]) + scene.place(triangle[1]) + scene.place(triangle[2])) / 3;
    const SurfacePoint centre =
        scene.picker.closest(place.cast<float>(), static_cast<float>(scene.surface.scale)).value();
    const DabChart chart = scene.builder.chart(centre, Vec3f(1, 2, 3), {radius, every_method[i % 3]});
    expect_finite_and_within(chart, radius);
    for (const Index vertex : chart.vertex) {
      ASSERT_LE((scene.place(vertex) - centre.position.cast<double>()).norm(), 2.00001 * radius);
    }
    charted += chart.size() > 0;
  }
  EXPECT_GT(charted, 20U);
}

INSTANTIATE_TEST_SUITE_P(Shared, NastyDab,
                         testing::Values("capsule.obj", "dragon_vrip_res3.ply", "fan3.obj",
                                         "hourglass_ico.obj", "moebius.obj", "not_convex.obj", "soup.stl"),
                         [](const auto& mesh) { return test::test_name_of(mesh.param); });

}  // namespace
}  // namespace burin
