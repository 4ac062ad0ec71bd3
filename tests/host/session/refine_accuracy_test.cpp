// Strokes that refine the surface against the same ones on finer meshes and against exact distances, drawn
// through sessions.
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/euler.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "refining.h"

namespace burin::test {
namespace {

/// A plate with round corners of slivers, whose long sides are 200 times as long as the short ones.
TriangleMesh sliver_plate() {
  constexpr int steps = 60;  // of each corner
  const auto corner = [](double x, double y, double begin, std::vector<Vec3d>& outline) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = (begin + static_cast<double>(i) / steps) * std::numbers::pi / 2;
      outline.emplace_back(x + 0.2 * std::cos(angle), y + 0.2 * std::sin(angle), 0);
    }
  };
  std::vector<Vec3d> outline;
  corner(1.8, 0.2, -1, outline);
  corner(1.8, 0.8, 0, outline);
  corner(0.2, 0.8, 1, outline);
  corner(0.2, 0.2, 2, outline);
  TriangleMesh mesh;
  for (const Vec3d& p : outline)
    for (const double z : {0., 1.})
      mesh.positions.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                  static_cast<float>(z));
  const auto count = static_cast<Index>(outline.size());
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % count);
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
    if (i == 0 || i + 1 == count) continue;
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
  }
  return mesh;
}

/// The mesh with edges of about this length all over.
TriangleMesh remeshed(const TriangleMesh& mesh, double edge) {
  const Surface surface = make_surface(mesh);
  std::vector<Index> all(surface.triangles.size());
  for (Index t = 0; t < all.size(); ++t) all[t] = t;
  const EdgeLength lengths({{Vec3d::Zero()}}, 100, edge);
  const Surface after = patched(surface, refine_surface(surface, lengths, all, 10'000'000).patch).surface;
  TriangleMesh result{after.positions, after.triangles};
  return result;
}

struct Difference {
  double rms = 0, most = 0;  ///< object units
  std::size_t count = 0;
};

/// How far the vertices that a stroke moved are from another surface.
Difference difference(const Session& one, const Session& other, double near) {
  const Surface& from = one.surface();
  Difference found;
  const SurfaceCurve& curve = one.curve();
  for (const Vec3f& p : from.positions) {
    const bool is_near = std::ranges::any_of(curve.points, [&](const CurvePoint& point) {
      return (point.at.position - p).squaredNorm() < static_cast<float>(near * near);
    });
    if (!is_near) continue;
    const double apart = static_cast<double>(
        (other.picker().closest(p, std::numeric_limits<float>::max())->position - p).norm());
    found.rms += apart * apart;
    found.most = std::max(found.most, apart);
    ++found.count;
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(found.count));
  return found;
}

/// Draws a stroke on a mesh that it refines, and on the same with such edges everywhere.
void expect_groove_of_uniform_mesh(const TriangleMesh& mesh, const std::vector<Vec3d>& path,
                                   const char* what) {
  SCOPED_TRACE(what);
  constexpr double edge = radius / 12, depth = 0.25 * radius;
  Session local(make_surface(mesh), brushes()), uniform(make_surface(remeshed(mesh, edge)), brushes());
  draw_along(local, refining(edge), path);
  Session automatic(make_surface(mesh), brushes());
  draw_along(automatic, refining_if_coarse(), path);
  EXPECT_EQ(automatic.refinements().size(), 1u);
  draw_along(uniform, settings("org.burin.groove", radius), path);
  const Difference found = difference(local, uniform, radius);
  EXPECT_GT(found.count, 1000u);
  EXPECT_LT(found.rms, 0.02 * depth);
  EXPECT_LT(local.surface().triangles.size(), uniform.surface().triangles.size());
}

TEST(RefineAccuracy, GivesTheGrooveOfAUniformMesh) {
  std::vector<Vec3d> over_the_corner = straight({1.5, 0.7, 1}, {2, 0.95, 1});
  for (const Vec3d& place : straight({2, 0.95, 1}, {2, 0.6, 0.6})) over_the_corner.push_back(place);
  over_the_corner.erase(over_the_corner.begin() + 41);
  std::vector<Vec3d> around;
  for (int i = 0; i <= 60; ++i) {
    const double angle = (-1 + i / 60.) * std::numbers::pi / 2;
    around.emplace_back(1.8 + 0.2 * std::cos(angle), 0.2 + 0.2 * std::sin(angle), 0.5 + 0.3 * i / 60.);
  }
  expect_groove_of_uniform_mesh(box({2, 1, 1}), over_the_edge(), "box, over an edge");
  expect_groove_of_uniform_mesh(box({2, 1, 1}), over_the_corner, "box, over a corner");
  expect_groove_of_uniform_mesh(sliver_plate(), around, "slivers");
}

TEST(RefineAccuracy, GivesExactDistancesOverTheEdgeOfABox) {
  Session session = box_session();
  StrokeSettings exact = refining_if_coarse();
  exact.follow = 1;
  exact.strength = 0;
  draw_along(session, exact, over_the_edge());
  // Unfolded, the path is straight on each of both faces and bends at the edge x = 2.
  const auto unfolded = [](const Vec3f& p) {
    const bool on_top = p.z() == 1;
    return Vec2d(on_top ? static_cast<double>(p.x()) : 3 - static_cast<double>(p.z()),
                 static_cast<double>(p.y()));
  };
  const std::array<Vec2d, 3> line{Vec2d(1.2, 0.4), Vec2d(2, 0.5), Vec2d(2.7, 0.6)};
  const Chart& chart = session.chart();
  double sum = 0;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Vec2d at = unfolded(session.surface().positions[chart.vertex[i]]);
    double nearest = 1e9;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec2d along = line[k + 1] - line[k], way = at - line[k];
      const double share = std::clamp(way.dot(along) / along.squaredNorm(), 0., 1.);
      nearest = std::min(nearest, (way - share * along).norm());
    }
    const double t = chart.t[i], d = static_cast<double>(chart.d[i]);
    const double beyond = std::max({-t, t - chart.length, 0.});
    sum += std::abs(std::sqrt(d * d + beyond * beyond) - nearest);
  }
  ASSERT_GT(chart.size(), 5000u);
  EXPECT_LT(sum / static_cast<double>(chart.size()), 0.003 * radius);
}

TEST(RefineAccuracy, GivesWhatAFineMeshGivesWithATenthOfItsTriangles) {
  std::vector<Vec3d> path;
  for (int i = 0; i <= 40; ++i)
    path.push_back(Vec3d(std::cos(0.02 * i), std::sin(0.02 * i), 0.2 * std::sin(0.1 * i)).normalized());
  constexpr double wide = 0.2, depth = 0.25 * wide;
  Session fine(make_surface(sphere(7, 0.1, 1)), brushes()),
      coarse(make_surface(sphere(3, 0.1, 2)), brushes());
  StrokeSettings with = settings("org.burin.groove", wide);
  draw_along(fine, with, path);
  with.refining = {.kind = Refining::Kind::edge, .edge = wide / 18};
  draw_along(coarse, with, path);
  EXPECT_LT(difference(coarse, fine, 0.9 * wide).rms, 0.01 * depth);
  EXPECT_LT(coarse.surface().triangles.size(), fine.surface().triangles.size() / 10);
}

// Dashes, which end with steps, to a hundredth of their height, on a tenth of the triangles of a fine mesh.
TEST(RefineAccuracy, RepresentsStepsToTheErrorAskedFor) {
  constexpr double wide = 0.3;
  const std::vector<Vec3d> path = straight({-0.3, 0, 0}, {0.3, 0.1, 0});
  Session fine(make_surface(shuffled(plane(0.75, wide / 75, 1), 2)), brushes()),
      coarse(make_surface(shuffled(plane(0.75, wide / 12, 3), 4)), brushes());
  StrokeSettings with = settings("org.burin.dashed-line", wide);
  draw_along(fine, with, path);
  double height = 0;
  for (const Vec3f& p : fine.positions()) height = std::max(height, static_cast<double>(p.z()));
  EXPECT_GT(height, 0.05 * wide);
  coarse.set_paint({std::vector<Vec4f>(coarse.surface().vertex_count(), Vec4f(0.1F, 0.2F, 0.3F, 1)), {}});
  const Everything before(coarse);
  with.refining = {.kind = Refining::Kind::error, .error = 0.02};
  draw_along(coarse, with, path);
  EXPECT_EQ(coarse.changed().size(), coarse.surface().vertex_count());
  EXPECT_LT(difference(coarse, fine, wide).rms, 0.01 * height);
  EXPECT_LT(coarse.surface().triangles.size(), fine.surface().triangles.size() / 4);
  EXPECT_EQ(euler_characteristic(coarse.surface()), 1);
  ASSERT_EQ(coarse.refinements().size(), 1u);
  EXPECT_NEAR(coarse.refinements()[0].edge, wide / Refining::finest, 1e-9);
  const Everything after(coarse);
  EXPECT_EQ(coarse.undo_count(), 1u);
  ASSERT_TRUE(coarse.undo());
  EXPECT_EQ(Everything(coarse), before);
  ASSERT_TRUE(coarse.redo());
  EXPECT_EQ(Everything(coarse), after);
}

}  // namespace
}  // namespace burin::test
