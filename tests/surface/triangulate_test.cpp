#include <burin/surface/mesh_file.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "support/shared_data.h"

namespace burin {
namespace {

PolygonMesh polygon(std::vector<Vec3f> positions) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  mesh.face_sizes = {static_cast<Index>(mesh.positions.size())};
  mesh.face_vertices.resize(mesh.positions.size());
  std::iota(mesh.face_vertices.begin(), mesh.face_vertices.end(), Index{0});
  return mesh;
}

Vec3d doubled_area(const TriangleMesh& mesh, const Triangle& t) {
  const auto corner = [&](int i) -> Vec3d { return mesh.positions[t[i]].cast<double>(); };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

/// Expects that triangles tile a polygon in the plane z = 0: none is flipped, and the areas add up.
void expect_tiles(const TriangleMesh& mesh, double area) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    EXPECT_GE(doubled_area(mesh, t).z(), 0);
    sum += doubled_area(mesh, t).z() / 2;
  }
  EXPECT_NEAR(sum, area, 1e-6);
}

TEST(Triangulate, SplitsQuadsAlongTheShorterDiagonal) {
  const auto tall = triangulate(polygon({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(tall.triangles, (std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}));
  const auto wide = triangulate(polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}));
  EXPECT_EQ(wide.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  const auto square = triangulate(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(square.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, SplitsAQuadWithANotchAlongTheDiagonalInside) {
  const auto mesh = triangulate(polygon({{0, 0, 0}, {3, 0, 0}, {0.5f, 0.5f, 0}, {0, 3, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  const auto longer = triangulate(polygon({{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 10, 0}}));
  EXPECT_EQ(longer.triangles, (std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Triangulate, ClipsEarsOfAStar) {
  std::vector<Vec3f> corners;
  for (int i = 0; i < 14; ++i) {
    const double r = i % 2 ? 0.3 : 1.0, angle = std::numbers::pi * i / 7;
    corners.push_back(Vec3d(r * std::cos(angle), r * std::sin(angle), 0).cast<float>());
  }
  const auto mesh = triangulate(polygon(corners));
  EXPECT_EQ(mesh.triangles.size(), 12u);
  expect_tiles(mesh, 14 * 0.5 * 0.3 * std::sin(std::numbers::pi / 7));
}

TEST(Triangulate, ClipsEarsOfAComb) {
  const auto mesh = triangulate(polygon({{0, 0, 0},
                                         {5, 0, 0},
                                         {5, 3, 0},
                                         {4, 3, 0},
                                         {4, 1, 0},
                                         {3, 1, 0},
                                         {3, 3, 0},
                                         {2, 3, 0},
                                         {2, 1, 0},
                                         {1, 1, 0},
                                         {1, 3, 0},
                                         {0, 3, 0}}));
  EXPECT_EQ(mesh.triangles.size(), 10u);
  expect_tiles(mesh, 5 * 1 + 3 * 2);
}

TEST(Triangulate, GivesCornersLessTwoTrianglesOfDegeneratePolygons) {
  EXPECT_EQ(triangulate(polygon(std::vector<Vec3f>(6, Vec3f(1, 2, 3)))).triangles.size(), 4u);
  EXPECT_EQ(triangulate(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}})).triangles.size(),
            3u);
  EXPECT_EQ(triangulate(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}})).triangles.size(),
            3u);
}

TEST(Triangulate, GivesTheTrianglesOfTheSpotCage) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/spot_control_mesh.obj");
  const TriangleMesh mesh = triangulate(read_mesh(path));
  EXPECT_EQ(mesh.triangles.size(), 372u);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(doubled_area(mesh, t).norm(), 0);
}

TEST(Triangulate, CarriesTextureCoordinates) {
  PolygonMesh mesh = polygon({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0.5F, 2, 0}, {-1, 1, 0}});
  mesh.face_sizes = {4, 3, 6};
  mesh.face_vertices = {0, 1, 2, 3, 3, 2, 4, 0, 1, 2, 3, 4, 5};
  for (const Index vertex : mesh.face_vertices)
    mesh.corner_uv.push_back(0.5F * mesh.positions[vertex].head<2>() + Vec2f(3, 4));
  const TriangleMesh triangles = triangulate(mesh);
  ASSERT_EQ(triangles.triangle_uv.size(), 2 + 1 + 4U);
  for (std::size_t i = 0; i < triangles.triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3f& position = triangles.positions[triangles.triangles[i][corner]];
      EXPECT_EQ(triangles.triangle_uv[i][corner], 0.5F * position.head<2>() + Vec2f(3, 4));
    }
  mesh.corner_uv.clear();
  EXPECT_TRUE(triangulate(mesh).triangle_uv.empty());
}

/// A square cut into two quads that share the edges from two opposite corners to its middle, with a tip below
/// that closes it.
PolygonMesh two_quads_over_a_tip() {
  PolygonMesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, -2, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 0.1F}, {0, 0, -1}};
  mesh.face_sizes = {4, 4, 3, 3, 3, 3};
  mesh.face_vertices = {0, 1, 2, 4, 0, 4, 2, 3, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};
  return mesh;
}

TEST(Triangulate, KeepsManifoldsOfQuadsThatShareTwoEdges) {
  for (const bool far : {false, true}) {
    PolygonMesh mesh = two_quads_over_a_tip();
    if (far) mesh.positions[4].z() = 1;  // both quads are now longer through the middle
    const MeshDefects defects = find_defects(triangulate(mesh));
    EXPECT_FALSE(defects.any()) << defects.text();
  }
}

TEST(Triangulate, CutsNoQuadWhereAnEdgeRuns) {
  PolygonMesh mesh = two_quads_over_a_tip();
  // The second quad as two triangles with an edge where the first is shortest.
  mesh.positions[4].z() = 1;
  mesh.face_sizes = {4, 3, 3, 3, 3, 3, 3};
  mesh.face_vertices = {0, 1, 2, 4, 0, 4, 2, 0, 2, 3, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};
  const MeshDefects defects = find_defects(triangulate(mesh));
  EXPECT_FALSE(defects.any()) << defects.text();
}

}  // namespace
}  // namespace burin
