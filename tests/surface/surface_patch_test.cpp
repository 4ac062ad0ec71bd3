#include <burin/base/error.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/surface_patch.h>
#include <burin/surface/topology/adjacency.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <vector>

#include "support/shapes.h"

namespace burin {
namespace {

/// The triangles by the numbers of their vertices in the source, the lowest first; ascending.
std::vector<Triangle> source_triangles(const Surface& surface) {
  std::vector<Triangle> triangles;
  for (const Triangle& t : surface.triangles) {
    Triangle source{surface.source_vertex[t[0]], surface.source_vertex[t[1]], surface.source_vertex[t[2]]};
    std::ranges::rotate(source, std::ranges::min_element(source));
    triangles.push_back(source);
  }
  std::ranges::sort(triangles);
  return triangles;
}

/// The vertex of the surface that was this one of the source.
Index vertex_of(const Surface& surface, Index source) {
  return static_cast<Index>(std::ranges::find(surface.source_vertex, source) - surface.source_vertex.begin());
}

/// A strip of three triangles, and vertex 4, which no triangle has.
TriangleMesh strip() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 0}, {0.5F, 2, 0}},
          {{0, 1, 2}, {1, 3, 2}, {2, 3, 5}},
          {}};
}

TEST(SurfacePatch, TakesThePlaceOfTriangles) {
  const Surface surface = make_surface(strip());
  const auto has = [&](Index t, Index source) {
    return std::ranges::find(surface.triangles[t], vertex_of(surface, source)) != surface.triangles[t].end();
  };
  SurfacePatch patch;
  for (Index t = 0; t < 3; ++t)
    if (has(t, 5)) patch.removed = {t};
  const Index first_new = surface.vertex_count();
  patch.positions = {{9, 9, 9}, {0.5F, 1.5F, 1}};  // of which no triangle has the first
  patch.triangles = {{vertex_of(surface, 2), vertex_of(surface, 3), first_new + 1}};

  const PatchedSurface result = patched(surface, patch);
  ASSERT_EQ(result.surface.vertex_count(), 6u) << "without the vertex that lost its triangle";
  EXPECT_EQ(source_triangles(result.surface), (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 5}}));
  EXPECT_EQ(result.surface.scale, surface.scale);
  for (Index source = 0; source < 6; ++source) {
    const Index vertex = vertex_of(result.surface, source);
    EXPECT_EQ(result.surface.positions[vertex], source < 5 ? strip().positions[source] : patch.positions[1]);
    EXPECT_EQ(result.came_from[vertex], source < 5 ? vertex_of(surface, source) : first_new + 1);
  }
}

TEST(SurfacePatch, ThatIsEmptyChangesNothing) {
  const Surface surface = make_surface(strip());
  const PatchedSurface result = patched(surface, {});
  EXPECT_EQ(result.surface.positions, surface.positions);
  EXPECT_EQ(result.surface.triangles, surface.triangles);
  EXPECT_EQ(result.surface.source_vertex, surface.source_vertex);
}

/// The first triangles of a surface, taken away, and random ones, each taken away or replaced by a fan around
/// a new vertex above it.
SurfacePatch random_patch(const Surface& surface, std::mt19937& random) {
  SurfacePatch patch;
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    if (t > 40 && random() % 3 != 0) continue;
    patch.removed.push_back(t);
    const auto [a, b, c] = surface.triangles[t];
    if (t <= 40 || random() % 3 == 0) continue;
    const Index middle = surface.vertex_count() + static_cast<Index>(patch.positions.size());
    patch.positions.push_back((surface.positions[a] + surface.positions[b] + surface.positions[c]) / 2.5F);
    patch.triangles.insert(patch.triangles.end(), {{c, a, middle}, {a, b, middle}, {b, c, middle}});
  }
  return patch;
}

// All that a surface has fits to its triangles, whatever was removed, and triangles are those of both.
TEST(SurfacePatch, MakesASurfaceOfWhatItHolds) {
  constexpr std::uint32_t seed = 5;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  Surface surface = make_surface(test::sphere(4, 0.2, 3));
  surface.triangle_uv.resize(surface.triangles.size());
  const auto uv_of = [](float number) { return TriangleUv{Vec2f(number, 0), Vec2f(0, 1), Vec2f(1, 1)}; };
  for (Index t = 0; t < surface.triangles.size(); ++t) surface.triangle_uv[t] = uv_of(static_cast<float>(t));
  SurfacePatch patch = random_patch(surface, random);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    patch.triangle_uv.push_back(uv_of(-1 - static_cast<float>(t)));
  const auto [made, came_from] = patched(surface, patch);
  EXPECT_LT(made.vertex_count(), surface.vertex_count() + patch.positions.size()) << "some vertex is gone";

  ASSERT_EQ(made.triangles.size(), surface.triangles.size() - patch.removed.size() + patch.triangles.size());
  for (std::size_t t = 0; t < made.triangles.size(); ++t) {
    const auto number = static_cast<int>(made.triangle_uv[t][0].x());
    const Triangle& is = number < 0 ? patch.triangles[static_cast<std::size_t>(-1 - number)]
                                    : surface.triangles[static_cast<std::size_t>(number)];
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(came_from[made.triangles[t][i]], is[i]);
    ASSERT_TRUE(number < 0 || !std::ranges::binary_search(patch.removed, static_cast<Index>(number)));
  }
  const Csr incident = incident_triangles(made.vertex_count(), made.triangles),
            neighbours = neighbour_vertices(made.triangles, incident);
  EXPECT_EQ(made.incident.offsets, incident.offsets);
  EXPECT_EQ(made.incident.items, incident.items);
  EXPECT_EQ(made.neighbours.offsets, neighbours.offsets);
  EXPECT_EQ(made.neighbours.items, neighbours.items);
  for (Index v = 0; v < made.vertex_count(); ++v) {
    ASSERT_EQ(made.normals[v], vertex_normal(made, made.positions, v));
    ASSERT_EQ(made.gauss_curvature[v], gauss_curvature(made, v));
  }
}

TEST(SurfacePatch, ThatLeavesNothingIsRefused) {
  const Surface surface = make_surface(strip());
  SurfacePatch patch;
  patch.removed = {0, 1, 2};
  EXPECT_THROW(patched(surface, patch), Error);
}

}  // namespace
}  // namespace burin
