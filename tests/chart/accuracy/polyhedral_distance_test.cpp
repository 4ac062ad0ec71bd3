// Compares the oracle with CGAL's Surface_mesh_shortest_path. Some releases of CGAL miss a shortest path.
// Both lengths belong to paths on the surface, so the shorter one is right.
#include "support/oracles/polyhedral_distance.h"

#include <burin/surface/mesh_file.h>
#include <burin/surface/picker.h>
#include <burin/surface/picking/closest_point.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "support/drawn_strokes.h"
#include "support/oracles/cgal_distance.h"
#include "support/shared_data.h"

namespace burin {
namespace {

test::Region ball(const Surface& surface, const Vec3f& centre, float radius) {
  std::vector<Index> triangles;
  for (Index triangle = 0; triangle < surface.triangles.size(); ++triangle) {
    const auto& [a, b, c] = surface.triangles[triangle];
    const Vec3f middle = (surface.positions[a] + surface.positions[b] + surface.positions[c]) / 3;
    if ((middle - centre).norm() < radius) triangles.push_back(triangle);
  }
  return test::make_region(surface, std::move(triangles));
}

struct Agreement {
  std::size_t count = 0, same = 0;
};

/// Compares the distances from the middle of a triangle to all vertices of the region.
void compare(const Surface& surface, const test::Region& region, Index triangle, Agreement& agreement) {
  const SurfacePoint middle = point_on(surface, region.triangles[triangle], 1. / 3, 1. / 3);
  const auto distances = test::polyhedral_distances(surface, region, middle);
  ASSERT_TRUE(distances.has_value());
  const std::vector<double> theirs = test::cgal_distances(surface, region, triangle);
  const double tolerance = 1e-6 * surface.scale;
  for (std::size_t v = 0; v < theirs.size(); ++v) {
    if (theirs[v] < 0) continue;  // no way leads there
    EXPECT_LE((*distances)[v], theirs[v] + tolerance);
    agreement.same += std::abs((*distances)[v] - theirs[v]) <= tolerance;
    ++agreement.count;
  }
}

// The mesh has saddles, where shortest paths bend, and folds, which shortest paths go around.
TEST(PolyhedralDistance, IsNeverLongerThanCgals) {
  BURIN_SHARED_DATA_OR_SKIP(file, "meshes/stanford-bunny.obj");
  const Surface surface = make_surface(triangulate(read_mesh(file)));
  const std::uint32_t seed = 77;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  Agreement agreement;
  for (int i = 0; i < 12; ++i) {
    const Vec3f centre = surface.positions[random() % surface.positions.size()];
    const test::Region region = ball(surface, centre, static_cast<float>(0.1 * surface.scale));
    compare(surface, region, static_cast<Index>(random() % region.triangles.size()), agreement);
  }
  EXPECT_GT(agreement.count, 15'000U);
  std::cout << agreement.same << " of " << agreement.count << " the same\n";
  EXPECT_GT(static_cast<double>(agreement.same), 0.9 * static_cast<double>(agreement.count));
}

/// The largest error of distances to a bent line on the shape, in shares of the most that is asked.
double largest_error(const test::ExactShape& shape, double edge) {
  constexpr double most = 0.3;
  const Surface surface = make_surface(shape.mesh(edge, 1, 5));
  const Picker picker(surface);
  std::vector<SurfacePoint> points;
  for (double s = -0.4; s <= 0.4; s += edge / 4)
    points.push_back(*picker.closest(shape.place({s, 0.5 * std::abs(s)}).cast<float>(), 0.1F));
  const test::Region region = ball(surface, points[points.size() / 2].position, 1);
  test::PolylineDistance distance(surface, region, points);
  EXPECT_TRUE(distance.is_known());
  std::mt19937 random(78);
  double largest = 0;
  for (int i = 0; i < 400; ++i) {
    const Index vertex = region.vertices[random() % region.vertices.size()];
    const Vec3d x = surface.positions[vertex].cast<double>();
    double exact = most;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      exact = std::min(
          exact, shape.distance(x, points[k].position.cast<double>(), points[k + 1].position.cast<double>()));
    if (exact < most)
      largest = std::max(largest, std::abs(distance.from(vertex, most).distance - exact) / most);
  }
  std::cout << 100 * largest << " % at edges of " << edge << "\n";
  return largest;
}

// The tolerance on the sphere covers the difference between polyhedron and sphere.
TEST(PolylineDistance, IsThatOfShapes) {
  EXPECT_LT(largest_error(*test::exact_plane(), 0.03), 1e-5);
  EXPECT_LT(largest_error(*test::exact_cylinder(), 0.03), 1e-3);
  EXPECT_LT(largest_error(*test::exact_sphere(), 0.03), 1e-3);
}

}  // namespace
}  // namespace burin
