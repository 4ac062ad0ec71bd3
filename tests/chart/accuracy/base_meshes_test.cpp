// Tests charts over base surfaces on difficult meshes of the plane: slivers, varying density, holes and
// borders. The exact coordinates about an arc are polar. Errors are in percent of the radius.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "support/charted.h"
#include "support/relief.h"
#include "support/shapes.h"

namespace burin {
namespace {

constexpr double radius = 1;

/// The stroke goes around the origin to the left, at this distance, between these angles.
constexpr double arc_radius = 2.5, first_angle = 0.8, last_angle = 2.34;

/// Seen from above.
std::vector<Ray> arc() {
  std::vector<Ray> pens;
  for (int i = 0; i < 120; ++i) {
    const double angle = first_angle + (last_angle - first_angle) * i / 119;
    pens.push_back(
        {Vec3d(arc_radius * std::cos(angle), arc_radius * std::sin(angle), 5).cast<float>(), {0, 0, -1}});
  }
  return pens;
}

struct Errors {
  double t_mean = 0, d_mean = 0, t_max = 0, d_max = 0;  ///< percent of the radius
  std::size_t charted = 0;  ///< vertices whose exact coordinates are well inside of the stroke, with a node
  std::size_t missing = 0;  ///< the same, without
  std::size_t strayed = 0;  ///< nodes of vertices that are well outside
};

/// The errors of the vertices for which counts(position in the plane) is true, away from the stroke's ends.
Errors errors(
    TriangleMesh mesh, test::Relief relief, double height, double follow = 0,
    const std::function<bool(const Vec2d&)>& counts = [](const Vec2d&) { return true; }) {
  const std::vector<Vec3f> feet = mesh.positions;
  std::vector<bool> in_mesh(feet.size());
  for (const Triangle& triangle : mesh.triangles)
    for (const Index corner : triangle) in_mesh[corner] = true;
  for (Vec3f& at : mesh.positions)
    if (height > 0) at.z() = static_cast<float>(height * radius * relief(at.x() / radius, at.y() / radius));
  test::Charted on(std::move(mesh));
  const Chart chart = on.chart({.radius = radius, .follow = follow}, arc());
  std::vector<std::size_t> node_of(feet.size(), chart.size());
  for (std::size_t i = 0; i < chart.size(); ++i) node_of[on.surface.source_vertex[chart.vertex[i]]] = i;
  Errors errors;
  for (std::size_t v = 0; v < feet.size(); ++v) {
    if (!in_mesh[v]) continue;
    const Vec2d foot(feet[v].x(), feet[v].y());
    const double angle = std::atan2(foot.y(), foot.x());
    const double exact_t = arc_radius * (angle - first_angle), exact_d = arc_radius - foot.norm();
    const bool in_middle = exact_t > radius / 2 && exact_t < on.curve.length() - radius / 2;
    const std::size_t node = node_of[v];
    const Vec2d end =
        on.curve.points[exact_t < 0 ? 0 : on.curve.points.size() - 1].at.position.head<2>().cast<double>();
    const bool beyond_ends = exact_t < 0 || exact_t > on.curve.length();
    const double outside = beyond_ends ? (foot - end).norm() : std::abs(exact_d);
    if (node < chart.size() && outside > 1.05 * radius) ++errors.strayed;
    if (!in_middle || std::abs(exact_d) > 0.97 * radius || !counts(foot)) continue;
    if (node == chart.size()) {
      ++errors.missing;
      continue;
    }
    const double t = 100 / radius * std::abs(chart.t[node] - exact_t);
    const double d = 100 / radius * std::abs(static_cast<double>(chart.d[node]) - exact_d);
    errors.t_mean += t;
    errors.d_mean += d;
    errors.t_max = std::max(errors.t_max, t);
    errors.d_max = std::max(errors.d_max, d);
    ++errors.charted;
  }
  errors.t_mean /= static_cast<double>(errors.charted);
  errors.d_mean /= static_cast<double>(errors.charted);
  return errors;
}

std::ostream& operator<<(std::ostream& out, const Errors& errors) {
  return out << "t mean " << errors.t_mean << " max " << errors.t_max << ", d mean " << errors.d_mean
             << " max " << errors.d_max << " % of r; " << errors.charted << " nodes, " << errors.missing
             << " missing, " << errors.strayed << " strayed";
}

void expect_within(const Errors& errors, double mean, double most, const char* what) {
  EXPECT_GT(errors.charted, 300U) << what;
  EXPECT_EQ(errors.missing, 0U) << what;
  // Round caps of strokes on slivers under bumps are too wide by more than a twentieth at single vertices.
  EXPECT_LE(errors.strayed, errors.charted / 500) << what << ": " << errors;
  EXPECT_LE(errors.t_mean, mean) << what << ": " << errors;
  EXPECT_LE(errors.d_mean, mean) << what << ": " << errors;
  EXPECT_LE(errors.t_max, most) << what << ": " << errors;
  EXPECT_LE(errors.d_max, most) << what << ": " << errors;
}

/// |x| <= 3, 0.5 <= y <= 4, in cells of these edges.
TriangleMesh rectangle(double edge_x, double edge_y) {
  return test::shuffled(test::patch({.u_min = -3,
                                     .u_max = 3,
                                     .v_min = 0.5,
                                     .v_max = 4,
                                     .cells_u = static_cast<int>(std::lround(6 / edge_x)),
                                     .cells_v = static_cast<int>(std::lround(3.5 / edge_y))},
                                    [](double x, double y) { return Vec3d(x, y, 0); }),
                        3);
}

/// Edges grow with the distance from a point to the left of the stroke, 10:1 from one side to the other: the
/// exponential map of a grid, whose cells stay square.
TriangleMesh growing_edges() {
  constexpr double least = 0.6, most = 6.5;
  const double edge = 0.035;  // times the distance
  const int cells_u = static_cast<int>(std::lround(std::log(most / least) / edge));
  const int cells_v = static_cast<int>(std::lround(2.4 / edge));
  return test::shuffled(test::patch({.u_min = std::log(least),
                                     .u_max = std::log(most),
                                     .v_min = -1.2,
                                     .v_max = 1.2,
                                     .cells_u = cells_u,
                                     .cells_v = cells_v},
                                    [](double u, double v) {
                                      return Vec3d(std::exp(u) * std::cos(v) - 3.2,
                                                   std::exp(u) * std::sin(v) + 2.2, 0);
                                    }),
                        3);
}

/// The mesh without vertices that no triangle has.
TriangleMesh used(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::vector<Index> place(mesh.positions.size(), no_index);
  for (Triangle triangle : mesh.triangles) {
    for (Index& corner : triangle) {
      if (place[corner] == no_index) {
        place[corner] = static_cast<Index>(result.positions.size());
        result.positions.push_back(mesh.positions[corner]);
      }
      corner = place[corner];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

TriangleMesh without(TriangleMesh mesh, const std::function<bool(const Vec3f&)>& cut) {
  std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](Index corner) { return cut(mesh.positions[corner]); });
  });
  return used(mesh);
}

TEST(BaseMeshes, AreNoMatterForTheBarePlane) {
  expect_within(errors(rectangle(0.05, 0.05), nullptr, 0), 0.03, 0.5, "even");
  expect_within(errors(rectangle(0.025, 0.25), nullptr, 0), 0.03, 0.5, "slivers across");
  expect_within(errors(growing_edges(), nullptr, 0), 0.03, 0.5, "growing edges");
}

// Four edges in a radius are too few for more: the chart is as good as one that spreads over the vertices.
TEST(BaseMeshes, MayHaveSliversAlongTheStroke) {
  const Errors own_scale = errors(rectangle(0.25, 0.025), nullptr, 0);
  const Errors over_vertices = errors(rectangle(0.25, 0.025), nullptr, 0, 1);
  EXPECT_EQ(own_scale.missing, 0U);
  EXPECT_LE(own_scale.t_mean, 1.2 * over_vertices.t_mean) << own_scale << "; " << over_vertices;
  EXPECT_LE(own_scale.d_mean, 1.2 * over_vertices.d_mean) << own_scale << "; " << over_vertices;
}

TEST(BaseMeshes, HardlyMatterUnderBumps) {
  for (const test::Relief relief : {&test::egg_crate, &test::band_noise}) {
    expect_within(errors(rectangle(0.05, 0.05), relief, 0.05), 0.3, 3, "even");
    expect_within(errors(rectangle(0.02, 0.1), relief, 0.05), 0.3, 3, "slivers");
  }
}

// A hole beside the stroke: exact where the way from the foot does not lead through it.
TEST(BaseMeshes, MayHaveHoles) {
  for (const double away : {0.3, 0.6, -0.3, -0.6}) {
    const Vec2d middle(0, arc_radius + away);
    constexpr double hole = 0.25;
    const auto mesh = without(rectangle(0.05, 0.05), [&](const Vec3f& at) {
      return std::hypot(at.x() - middle.x(), at.y() - middle.y()) < hole;
    });
    const auto in_sight = [&](const Vec2d& foot) {
      const Vec2d direction = foot.normalized(), way = (arc_radius - foot.norm()) * direction;
      const double along = std::clamp((middle - foot).dot(way) / way.squaredNorm(), 0., 1.);
      return (foot + along * way - middle).norm() > hole + 0.15;
    };
    expect_within(errors(mesh, nullptr, 0, 0, in_sight), 0.03, 0.5, "bare");
    expect_within(errors(mesh, &test::egg_crate, 0.05, 0, in_sight), 0.3, 3, "bumps");
  }
}

// The stroke goes along a border, on either side of it.
TEST(BaseMeshes, MayEndBesideTheStroke) {
  for (const double border : {0.2, 0.5}) {
    const auto outer = [&](const Vec3f& at) { return std::hypot(at.x(), at.y()) > arc_radius + border; };
    const auto inner = [&](const Vec3f& at) { return std::hypot(at.x(), at.y()) < arc_radius - border; };
    const auto kept = [&](const Vec2d& foot) { return std::abs(foot.norm() - arc_radius) < border - 0.12; };
    expect_within(errors(without(rectangle(0.05, 0.05), outer), nullptr, 0, 0,
                         [&](const Vec2d& foot) { return foot.norm() < arc_radius || kept(foot); }),
                  0.03, 0.5, "outer border");
    expect_within(errors(without(rectangle(0.05, 0.05), inner), nullptr, 0, 0,
                         [&](const Vec2d& foot) { return foot.norm() > arc_radius || kept(foot); }),
                  0.03, 0.5, "inner border");
    expect_within(errors(without(rectangle(0.05, 0.05), outer), &test::egg_crate, 0.05, 0,
                         [&](const Vec2d& foot) { return foot.norm() < arc_radius || kept(foot); }),
                  0.3, 3, "outer border, bumps");
  }
}

/// Lays a patch of fine cells |x| < 3, 0.5 < y < 4 into a wide one of ten times coarser cells; the middle
/// row of either is shared.
TriangleMesh fine_part_of_coarse_plane() {
  TriangleMesh mesh = test::patch({.u_min = -3,
                                   .u_max = 3,
                                   .v_min = 0.5,
                                   .v_max = 4,
                                   .cells_u = 120,
                                   .cells_v = 70,
                                   .jitter_u = 0.2,
                                   .jitter_v = 0.2},
                                  [](double x, double y) { return Vec3d(x, y, 0); });
  const TriangleMesh coarse =
      without(test::patch({.u_min = -60,
                           .u_max = 60,
                           .v_min = -59.5,
                           .v_max = 60.5,
                           .cells_u = 240,
                           .cells_v = 240,
                           .jitter_u = 0,
                           .jitter_v = 0},
                          [](double x, double y) { return Vec3d(x, y, 0); }),
              [](const Vec3f& at) { return std::abs(at.x()) < 2.9F && at.y() > 0.6F && at.y() < 3.9F; });
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), coarse.positions.begin(), coarse.positions.end());
  for (const auto& [a, b, c] : coarse.triangles)
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  return test::shuffled(mesh, 3);
}

// Scans have points that no triangle uses.
TEST(BaseMeshes, MayHaveLooseVertices) {
  const TriangleMesh mesh = rectangle(0.05, 0.05);
  TriangleMesh with_loose = mesh;
  std::mt19937 random(7);
  const auto share = [&] { return static_cast<float>(random()) / 4294967296.F; };
  for (int i = 0; i < 8000; ++i)
    with_loose.positions.emplace_back(-2.9F + 5.8F * share(), 0.6F + 3.3F * share(), 0.05F * share());
  for (const double bumps : {0., 0.05}) {
    const Errors without = errors(mesh, &test::egg_crate, bumps),
                 with = errors(with_loose, &test::egg_crate, bumps);
    EXPECT_NEAR(with.t_mean, without.t_mean, 0.02);
    EXPECT_NEAR(with.d_mean, without.d_mean, 0.02);
    EXPECT_NEAR(with.t_max, without.t_max, 0.2);
    EXPECT_EQ(with.charted, without.charted);
  }
}

// The brush has 20 edges where it draws, whatever the rest of the mesh has.
TEST(BaseMeshes, AreFeltWhereTheBrushIs) {
  expect_within(errors(fine_part_of_coarse_plane(), nullptr, 0), 0.03, 0.5, "bare");
  expect_within(errors(fine_part_of_coarse_plane(), &test::egg_crate, 0.05), 0.3, 3, "bumps");
}

}  // namespace
}  // namespace burin
