#include <burin/surface/surface_patch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

}  // namespace
}  // namespace burin
