#include <burin/surface/geometry/normals.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "surface/test_meshes.h"

namespace burin {
namespace {

/// A polar cap of a sphere in rings of `n`, whose vertices alternate so that faces differ in size and angle.
TriangleMesh sphere_cap(Index rings, Index n) {
  TriangleMesh mesh;
  mesh.positions.emplace_back(0, 0, 1);
  for (Index ring = 1; ring <= rings; ++ring)
    for (Index i = 0; i < n; ++i) {
      const double polar = 1.2 * ring / rings, around = 2 * std::numbers::pi * i / n;
      mesh.positions.push_back(
          Vec3d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar))
              .cast<float>());
    }
  const auto at = [&](Index ring, Index i) { return 1 + (ring - 1) * n + i % n; };
  for (Index i = 0; i < n; ++i) mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
  for (Index ring = 1; ring < rings; ++ring)
    for (Index i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  return mesh;
}

TEST(Normals, OfAPlaneAreItsNormal) {
  TriangleMesh mesh;
  const Vec3f across(0.6f, 0.8f, 0), up(0, 0, 1);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      mesh.positions.push_back((static_cast<float>(i * i) * across + static_cast<float>(j) * up).eval());
  for (Index i = 0; i < 5; ++i)
    for (Index j = 0; j < 5; ++j) {
      mesh.triangles.push_back({i * 6 + j, i * 6 + j + 6, i * 6 + j + 7});
      mesh.triangles.push_back({i * 6 + j, i * 6 + j + 7, i * 6 + j + 1});
    }
  for (const Vec3f& normal : make_surface(mesh).normals)
    EXPECT_LT((normal - Vec3f(0.8f, -0.6f, 0)).norm(), 1e-6f);
}

TEST(Normals, OfASphereApproachItsRadius) {
  for (const Index n : {40u, 80u}) {
    const Surface surface = make_surface(sphere_cap(n / 2, n));
    double worst = 0;
    for (Index v = 0; v < surface.vertex_count(); ++v)
      if (surface.positions[v].z() > 0.5f)
        worst = std::max<double>(worst, (surface.normals[v] - surface.positions[v]).norm());
    EXPECT_LT(worst, 8.0 / (n * n)) << n;  // second order in the size of a triangle
  }
}

/// A cylinder cut into columns of quads: by symmetry the normal is radial at every inner vertex if, and only
/// if, neither areas nor counts weigh the triangles.
TEST(Normals, OfACylinderAreRadialHoweverItsQuadsAreSplit) {
  TriangleMesh mesh;
  constexpr Index n = 24, rows = 5;
  for (Index row = 0; row < rows; ++row)
    for (Index i = 0; i < n; ++i) {
      const double around = 2 * std::numbers::pi * i / n;
      mesh.positions.push_back(Vec3d(std::cos(around), std::sin(around), 0.3 * row * row).cast<float>());
    }
  for (Index row = 0; row + 1 < rows; ++row)
    for (Index i = 0; i < n; ++i) {
      const Index a = row * n + i, b = row * n + (i + 1) % n, c = b + n, d = a + n;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  const Surface surface = make_surface(mesh);
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    const Vec3f& p = surface.positions[v];
    EXPECT_LT((surface.normals[v] - Vec3f(p.x(), p.y(), 0)).norm(), 1e-6f);
  }
}

/// The corner of a cube has the diagonal as its normal, whichever faces are cut through it.
TEST(Normals, OfACubesCornerAreItsDiagonal) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}},
                          {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {0, 3, 2}}};
  const Surface surface = make_surface(mesh);
  const auto corner = std::ranges::find(surface.source_vertex, Index{0}) - surface.source_vertex.begin();
  EXPECT_LT((surface.normals[static_cast<std::size_t>(corner)] + Vec3f(1, 1, 1).normalized()).norm(), 1e-6f);
}

TEST(Normals, AreUpWhereNoTriangleHasADirection) {
  // A flat triangle by itself, two sheets that face each other, and a vertex of no triangle.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 5, 0}, {1, 5, 0}, {0, 5, 1}, {9, 9, 9}},
                          {{0, 1, 2}, {3, 4, 5}, {3, 5, 4}}};
  for (const Vec3f& normal : make_surface(mesh).normals) EXPECT_EQ(normal, Vec3f(0, 0, 1));
}

TEST(Normals, IgnoreANeedleWhoseDirectionIsRounding) {
  // The needle's middle vertex stands off its line by a rounding, sideways, at an angle of almost pi.
  const TriangleMesh mesh{{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 1e-7f}, {2, 1, 1e-7f}},
                          {{0, 1, 2}, {3, 0, 4}}};
  const Surface surface = make_surface(mesh);
  const auto middle = std::ranges::find(surface.source_vertex, Index{0}) - surface.source_vertex.begin();
  EXPECT_EQ(surface.normals[static_cast<std::size_t>(middle)], Vec3f(0, 0, 1));
}

TEST(UpdateNormals, SetsThoseItIsAskedFor) {
  Surface surface = make_surface(test::torus(40, 20));
  std::vector<Vec3f> moved = surface.positions;
  for (Vec3f& position : moved) position.z() *= 2;
  std::vector<Index> some(100);
  std::iota(some.begin(), some.end(), Index{300});
  std::vector<Vec3f> normals(surface.normals);
  update_normals(surface, moved, some, normals);
  surface.positions = moved;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    EXPECT_EQ(normals[v], v >= 300 && v < 400 ? vertex_normal(surface, moved, v) : surface.normals[v]);
  EXPECT_GT((normals[350] - surface.normals[350]).norm(), 0.01f);
}

}  // namespace
}  // namespace burin
