#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>
#include <burin/surface/topology/defects.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace burin {
namespace {

PolygonMesh cage() { return read_mesh(BURIN_SAMPLES "/meshes/ewer.obj"); }

Surface refined(int level) { return make_surface(refine(cage(), SubdivisionScheme::catmull_clark, level)); }

/// Sum of the triangles' angles at each vertex.
std::vector<double> angle_sums(const Surface& surface) {
  std::vector<double> sums(surface.vertex_count(), 0.);
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d at = surface.positions[triangle[i]].cast<double>();
      const Vec3d a = surface.positions[triangle[(i + 1) % 3]].cast<double>() - at;
      const Vec3d b = surface.positions[triangle[(i + 2) % 3]].cast<double>() - at;
      sums[triangle[i]] += std::atan2(a.cross(b).norm(), a.dot(b));
    }
  return sums;
}

bool share_a_vertex(const Triangle& triangle, Index a, Index b) {
  return std::any_of(triangle.begin(), triangle.end(), [&](Index v) { return v == a || v == b; });
}

TEST(EwerCage, IsAQuadCageWithCreasesAndExtraordinaryVertices) {
  const PolygonMesh mesh = cage();
  EXPECT_TRUE(
      std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(), [](Index size) { return size == 4; }));
  EXPECT_EQ(mesh.creases.size(), 60u);
  std::vector<int> faces(mesh.positions.size(), 0);
  for (const Index vertex : mesh.face_vertices) ++faces[vertex];
  std::map<int, int> vertices_of_valence;
  for (const int valence : faces) ++vertices_of_valence[valence];
  EXPECT_EQ(vertices_of_valence[3], 8);  // corners of the two caps
  EXPECT_EQ(vertices_of_valence[5], 8);  // corners of the handle's two roots
}

TEST(EwerCage, RefinesToThreeMillionTriangles) {
  const int level = level_for_triangles(cage(), SubdivisionScheme::catmull_clark, 3'000'000);
  EXPECT_LE(level, 8);
  const std::size_t triangles = refined_triangle_count(cage(), SubdivisionScheme::catmull_clark, level);
  EXPECT_GE(triangles, 3'000'000u);
  EXPECT_LE(triangles, 4'000'000u);
}

TEST(EwerCage, RefinesToAClosedManifoldWithOneHandle) {
  const Surface surface = refined(3);
  EXPECT_EQ(find_defects({surface.positions, surface.triangles}).text(), "");
  // Closed: each of three half-edges a triangle has its twin. One handle: V - E + F = 0.
  const std::size_t edges = surface.neighbours.items.size() / 2;
  EXPECT_EQ(2 * edges, 3 * surface.triangles.size());
  EXPECT_EQ(surface.vertex_count() + surface.triangles.size(), edges);
}

TEST(EwerCage, CurvesBothWays) {
  double most = 0, least = 0;
  for (const double sum : angle_sums(refined(2))) {
    most = std::max(most, 2 * std::numbers::pi - sum);
    least = std::min(least, 2 * std::numbers::pi - sum);
  }
  EXPECT_GT(most, .05);
  EXPECT_LT(least, -.05);
}

TEST(EwerCage, DoesNotIntersectItself) {
  // Two triangles cross only where an edge of one pierces the other.
  const Surface surface = refined(3);
  const Picker picker(surface);
  std::size_t edges = 0, pierced = 0;
  for (Index a = 0; a < surface.vertex_count(); ++a)
    for (const Index b : surface.neighbours[a]) {
      const Vec3f from = surface.positions[a], way = surface.positions[b] - from;
      const auto hit = picker.pick({from + 1e-3f * way, way});
      const bool within = hit && (hit->position - from).norm() < .999f * way.norm();
      pierced += within && !share_a_vertex(surface.triangles[hit->triangle], a, b);
      ++edges;
    }
  EXPECT_GT(edges, 50'000u);
  EXPECT_EQ(pierced, 0u);
}

}  // namespace
}  // namespace burin
