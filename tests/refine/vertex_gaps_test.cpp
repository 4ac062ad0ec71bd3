// Gaps between vertices against closed forms: of a grid, of slivers, of one sliver in a fine mesh, of a
// patch.
#include <burin/refine/vertex_gaps.h>
#include <burin/surface/surface_patch.h>
#include <gtest/gtest.h>

#include <limits>

#include "refined.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// Squares of this edge, cut along their diagonals, from the origin on.
TriangleMesh grid(Index count, float edge) {
  TriangleMesh mesh;
  const auto at = [&](Index i, Index j) { return i * (count + 1) + j; };
  for (Index i = 0; i <= count; ++i)
    for (Index j = 0; j <= count; ++j)
      mesh.positions.emplace_back(static_cast<float>(i) * edge, static_cast<float>(j) * edge, 0.F);
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

TEST(VertexGaps, AreEdgesOfWellShapedTriangles) {
  const Surface surface = make_surface(grid(8, 0.25F));
  const VertexGaps gaps(surface);
  // The middle of a diagonal is as far from the other corners as from its ends.
  for (Index v = 0; v < surface.vertex_count(); ++v) EXPECT_NEAR(gaps[v], 0.25 * std::sqrt(2), 0.11);
  EXPECT_FLOAT_EQ(gaps.greatest(), 0.25F * std::sqrt(2.F));
  EXPECT_FLOAT_EQ(VertexGaps(make_surface(box({2, 1, 1}))).greatest(), std::sqrt(5.F));
}

TEST(VertexGaps, AreWideInRowsOfSliversOnly) {
  EXPECT_NEAR(VertexGaps(make_surface(slivers())).greatest(), 1, 1e-4);
  // The long side of one sliver, from (0, 0) to (2, 0), has a corner beside its middle.
  TriangleMesh one;
  one.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0.01F, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  one.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 4, 3}, {2, 1, 4}, {1, 5, 4}};
  EXPECT_NEAR(VertexGaps(make_surface(one)).greatest(), std::sqrt(2), 0.01);
}

TEST(VertexGaps, StayWhatTheyWereWhereASurfaceIsPatched) {
  const Surface surface = make_surface(box({2, 1, 1}));
  const VertexGaps gaps(surface);
  const EdgeLength lengths({straight({0.5, 0.5, 1}, {1.5, 0.5, 1})}, 0.1, 0.05);
  const std::array<Index, 2> all{4, 5};
  const PatchedSurface after = patched(surface, refine_surface(surface, lengths, all, 100'000));
  const VertexGaps measured = gaps.patched(after.surface, after.came_from, VertexGaps::Fresh::measured),
                   refined = gaps.patched(after.surface, after.came_from, VertexGaps::Fresh::refined),
                   anew(after.surface);
  std::size_t fresh = 0;
  for (Index v = 0; v < after.surface.vertex_count(); ++v) {
    const Index from = after.came_from[v];
    const bool is_fresh = from >= surface.vertex_count();
    EXPECT_EQ(measured[v], is_fresh ? anew[v] : gaps[from]);
    EXPECT_EQ(refined[v], is_fresh ? std::numeric_limits<float>::infinity() : gaps[from]);
    fresh += is_fresh;
  }
  EXPECT_GT(fresh, 400u);
}

}  // namespace
}  // namespace burin::test
