#include <burin/surface/topology/defects.h>
#include <burin/surface/triangulate.h>
#include <burin/surface/weld_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "surface/test_meshes.h"

namespace burin {
namespace {

PolygonMesh polygons(const TriangleMesh& mesh) {
  PolygonMesh result;
  result.positions = mesh.positions;
  for (const Triangle& triangle : mesh.triangles) {
    result.face_sizes.push_back(3);
    result.face_vertices.insert(result.face_vertices.end(), triangle.begin(), triangle.end());
  }
  return result;
}

/// Every corner with a vertex of its own.
PolygonMesh split(const PolygonMesh& mesh) {
  PolygonMesh result = mesh;
  result.positions.clear();
  for (Index& vertex : result.face_vertices) {
    result.positions.push_back(mesh.positions[vertex]);
    vertex = static_cast<Index>(result.positions.size() - 1);
  }
  return result;
}

PolygonMesh both(const PolygonMesh& a, const PolygonMesh& b) {
  PolygonMesh result = a;
  result.positions.insert(result.positions.end(), b.positions.begin(), b.positions.end());
  result.face_sizes.insert(result.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
  for (const Index vertex : b.face_vertices)
    result.face_vertices.push_back(vertex + static_cast<Index>(a.positions.size()));
  return result;
}

PolygonMesh moved(PolygonMesh mesh, const Vec3f& by) {
  for (Vec3f& position : mesh.positions) position += by;
  return mesh;
}

/// Seen from the other side.
PolygonMesh turned(PolygonMesh mesh) {
  std::ranges::reverse(mesh.face_vertices);
  return mesh;
}

/// Six squares around the cube from 0 to 1.
PolygonMesh cube() {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                                static_cast<float>(i >> 2));
  mesh.face_sizes.assign(6, 4);
  mesh.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return mesh;
}

/// n x n squares from 0 to 1, z 0.
PolygonMesh sheet(Index n) {
  PolygonMesh mesh;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x <= n; ++x)
      mesh.positions.emplace_back(static_cast<float>(x) / static_cast<float>(n),
                                  static_cast<float>(y) / static_cast<float>(n), 0);
  mesh.face_sizes.assign(std::size_t{n} * n, 4);
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index at = y * (n + 1) + x;
      for (const Index vertex : {at, at + 1, at + n + 2, at + n + 1}) mesh.face_vertices.push_back(vertex);
    }
  return mesh;
}

struct WeldedMesh {
  PolygonMesh mesh;
  std::vector<Index> vertex_of;
};

WeldedMesh weld_mesh(const PolygonMesh& mesh, double tolerance) {
  std::vector<Index> vertex_of = find_welds(mesh, tolerance);
  PolygonMesh welded = weld(mesh, vertex_of);
  return {std::move(welded), std::move(vertex_of)};
}

MeshDefects defects(const PolygonMesh& mesh) { return find_defects(triangulate(mesh)); }

/// Expects that two meshes have the same faces at the same positions.
void expect_same_surface(const PolygonMesh& a, const PolygonMesh& b) {
  ASSERT_EQ(a.face_sizes, b.face_sizes);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  for (std::size_t i = 0; i < a.face_vertices.size(); ++i)
    ASSERT_EQ(a.positions[a.face_vertices[i]], b.positions[b.face_vertices[i]]);
}

TEST(WeldMesh, LeavesWhatHangsTogetherAsItIs) {
  for (const PolygonMesh& mesh : {polygons(test::torus(12, 8)), cube(), sheet(4)}) {
    const WeldedMesh welded = weld_mesh(mesh, rounding_tolerance(mesh));
    EXPECT_TRUE(welded.vertex_of.empty());
    EXPECT_EQ(welded.mesh.face_vertices, mesh.face_vertices);
    EXPECT_EQ(welded.mesh.positions, mesh.positions);
  }
}

TEST(WeldMesh, JoinsCornersThatHaveTheirOwnVertices) {
  for (const PolygonMesh& mesh : {polygons(test::torus(12, 8)), cube(), sheet(4)}) {
    const PolygonMesh soup = split(mesh);
    const WeldedMesh welded = weld_mesh(soup, 0);
    expect_same_surface(welded.mesh, mesh);
    EXPECT_FALSE(defects(welded.mesh).any()) << defects(welded.mesh).text();
    ASSERT_EQ(welded.vertex_of.size(), soup.positions.size());
    for (std::size_t i = 0; i < soup.positions.size(); ++i)
      EXPECT_EQ(welded.mesh.positions[welded.vertex_of[i]], soup.positions[i]);
  }
}

TEST(WeldMesh, HealsRoundingOnly) {
  std::mt19937 random(5);
  const PolygonMesh torus = polygons(test::torus(24, 16));
  PolygonMesh soup = split(torus);
  const float greatest = static_cast<float>(rounding_tolerance(soup));
  std::uniform_real_distribution<float> off(-greatest / 4, greatest / 4);
  for (Vec3f& position : soup.positions)
    for (float& coordinate : position) coordinate += off(random);
  EXPECT_GT(weld_mesh(soup, 0).mesh.positions.size(), 2 * torus.positions.size());
  EXPECT_EQ(weld_mesh(soup, rounding_tolerance(soup)).mesh.positions.size(), torus.positions.size());

  const PolygonMesh apart = both(sheet(2), moved(sheet(2), {1.01F, 0, 0}));
  EXPECT_TRUE(weld_mesh(apart, rounding_tolerance(apart)).vertex_of.empty());
  EXPECT_EQ(weld_mesh(apart, 0.02).mesh.positions.size(), 15u);
  // Never so far that a face would collapse.
  EXPECT_FALSE(defects(weld_mesh(split(cube()), 1e9).mesh).any());
}

TEST(WeldMesh, KeepsDoubledMeshesApart) {
  for (const PolygonMesh& mesh : {cube(), sheet(3), polygons(test::torus(9, 6))})
    for (const PolygonMesh& other : {mesh, turned(mesh)}) {
      EXPECT_TRUE(weld_mesh(both(mesh, other), 1e-6).vertex_of.empty());
      const WeldedMesh soup = weld_mesh(both(split(mesh), split(other)), 1e-6);
      expect_same_surface(soup.mesh, both(mesh, other));
      EXPECT_EQ(defects(soup.mesh).non_manifold_edges, 0u);
      EXPECT_EQ(defects(soup.mesh).non_manifold_vertices, 0u);
    }
}

TEST(WeldMesh, KeepsBodiesThatTouchApart) {
  for (const Vec3f& by : {Vec3f(1, 1, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 1)}) {
    const PolygonMesh touching = both(cube(), moved(cube(), by));
    EXPECT_TRUE(weld_mesh(touching, 1e-6).vertex_of.empty());
    const WeldedMesh soup = weld_mesh(split(touching), 1e-6);
    expect_same_surface(soup.mesh, touching);
  }
}

TEST(WeldMesh, JoinsTheStraightestOfThreeSheets) {
  PolygonMesh upright = sheet(2);
  for (Vec3f& p : upright.positions) p = {1, p.y(), p.x()};
  const WeldedMesh welded = weld_mesh(both(both(sheet(2), upright), moved(sheet(2), {1, 0, 0})), 0);
  EXPECT_EQ(welded.mesh.positions.size(), 24u);
  EXPECT_EQ(defects(welded.mesh).non_manifold_edges, 0u);
  EXPECT_EQ(welded.vertex_of[2], welded.vertex_of[18]);  // the ends of the two flat ones
}

TEST(WeldMesh, JoinsFacesThatDisagreeOnTheOutside) {
  EXPECT_EQ(weld_mesh(both(sheet(2), moved(turned(sheet(2)), {1, 0, 0})), 0).mesh.positions.size(), 15u);
}

TEST(WeldMesh, ClosesPolesWhoseCornersRepeat) {
  // A fan of squares around a pole: each has two corners of its own there.
  PolygonMesh fan;
  constexpr Index n = 6;
  for (Index i = 0; i < n; ++i) {
    const float angle = static_cast<float>(i) * 2 * 3.14159265F / n;
    fan.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (Index i = 0; i < n; ++i) {
    for (int twice = 0; twice < 2; ++twice) fan.positions.emplace_back(0, 0, 1);
    fan.face_sizes.push_back(4);
    for (const Index vertex : {i, (i + 1) % n, n + 2 * i, n + 2 * i + 1}) fan.face_vertices.push_back(vertex);
    for (const float u : {0.0F, 1.0F, 1.0F, 0.0F}) fan.corner_uv.emplace_back(u, u);
  }
  const WeldedMesh welded = weld_mesh(fan, 0);
  EXPECT_EQ(welded.mesh.positions.size(), n + 1);
  EXPECT_EQ(welded.mesh.face_sizes, std::vector<Index>(n, 3));
  EXPECT_EQ(welded.mesh.corner_uv.size(), 3 * n);
  EXPECT_FALSE(defects(welded.mesh).any()) << defects(welded.mesh).text();
}

TEST(WeldMesh, CarriesWhatVerticesHave) {
  PolygonMesh mesh = both(sheet(1), moved(sheet(1), {1, 0, 0}));
  mesh.creases = {{5, 7, 2}};
  mesh.corners = {{6, 1}};
  mesh.paint.masks = {0, 1, 2, 3, 4, 5, 6, 7};
  const PolygonMesh welded = weld_mesh(mesh, 0).mesh;
  EXPECT_EQ(welded.paint.masks, (std::vector<float>{0, 1, 2, 3, 5, 7}));
  EXPECT_EQ(welded.creases[0].a, 4u);
  EXPECT_EQ(welded.creases[0].b, 5u);
  EXPECT_EQ(welded.corners[0].vertex, 3u);
}

}  // namespace
}  // namespace burin
