// Gaps between vertices against closed forms: of a grid, of slivers, of one sliver in a fine mesh, of a
// patch, of what was drawn on.
#include <burin/base/sort_unique.h>
#include <burin/refine/coarsen_surface.h>
#include <burin/refine/given_shape.h>
#include <burin/surface/surface_patch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

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

TEST(GivenShape, AreEdgesOfWellShapedTriangles) {
  const Surface surface = make_surface(grid(8, 0.25F));
  const GivenShape given(surface);
  // The middle of a diagonal is as far from the other corners as from its ends.
  for (Index v = 0; v < surface.vertex_count(); ++v) EXPECT_NEAR(given.gap(v), 0.25 * std::sqrt(2), 0.11);
  EXPECT_FLOAT_EQ(given.greatest_gap(), 0.25F * std::sqrt(2.F));
  EXPECT_FLOAT_EQ(GivenShape(make_surface(box({2, 1, 1}))).greatest_gap(), std::sqrt(5.F));
}

TEST(GivenShape, AreWideInRowsOfSliversOnly) {
  EXPECT_NEAR(GivenShape(make_surface(slivers())).greatest_gap(), 1, 1e-4);
  // The long side of one sliver, from (0, 0) to (2, 0), has a corner beside its middle.
  TriangleMesh one;
  one.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0.01F, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  one.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 4, 3}, {2, 1, 4}, {1, 5, 4}};
  EXPECT_NEAR(GivenShape(make_surface(one)).greatest_gap(), std::sqrt(2), 0.01);
}

/// The numbers of vertices that a patch added, and their places on the surface as it was given.
struct Patched {
  Patched(const Surface& before, const GivenShape& shape, const EdgeLength& lengths,
          std::span<const Index> seeds)
      : made(refine_surface(before, lengths, seeds, 100'000, shape.positions(before))),
        after(patched(before, made.patch)) {}
  bool is_new(Index v, const Surface& before) const { return after.came_from[v] >= before.vertex_count(); }

  SurfaceRefinement made;
  PatchedSurface after;
};

TEST(GivenShape, HasTheGapsThatPatchesLeave) {
  const Surface surface = make_surface(box({2, 1, 1}));
  const GivenShape given(surface);
  const EdgeLength lengths({straight({0.5, 0.5, 1}, {1.5, 0.5, 1})}, 0.1, 0.05);
  const Patched made(surface, given, lengths, std::array<Index, 2>{4, 5});
  const auto& [after, came_from] = made.after;
  const GivenShape refined = given.patched(after, came_from, {made.made.given, made.made.edges}),
                   solid = given.patched(after, came_from, {}), anew(after);
  std::size_t fresh = 0;
  for (Index v = 0; v < after.vertex_count(); ++v) {
    EXPECT_EQ(refined.is_refined(v), made.is_new(v, surface));
    EXPECT_FALSE(solid.is_refined(v));
    if (made.is_new(v, surface)) EXPECT_EQ(refined.gap(v), anew.gap(v));
    EXPECT_EQ(solid.gap(v), refined.gap(v));
    EXPECT_LE(refined.gap(v), std::sqrt(5.F));
    fresh += refined.is_refined(v);
  }
  EXPECT_GT(fresh, 400u);
}

// Vertices know for which edges they were added, or kept; where some are taken out the gaps are wider again.
TEST(GivenShape, KnowsForWhichEdgesVerticesAreThere) {
  const Surface surface = make_surface(box({2, 1, 1}));
  const GivenShape bare(surface);
  const EdgeLength lengths({straight({0.5, 0.5, 1}, {1.5, 0.5, 1})}, 0.1, 0.05);
  const Patched made(surface, bare, lengths, std::array<Index, 2>{4, 5});
  const auto& [fine, came_from] = made.after;
  GivenShape given = bare.patched(fine, came_from, {made.made.given, made.made.edges});
  EXPECT_FLOAT_EQ(given.least_edge(), 0.05F);
  EXPECT_GT(bare.least_edge(), 1e9F);
  std::vector<Index> added;
  for (Index v = 0; v < fine.vertex_count(); ++v) {
    if (made.is_new(v, surface)) added.push_back(v);
    const double there = lengths.at(fine.positions[v].cast<double>());
    EXPECT_EQ(given.is_finer(v, 1.0001 * there), made.is_new(v, surface));
    EXPECT_FALSE(given.is_finer(v, 0.9999 * there));
  }
  KeptEdges kept{{added[3], added[5]}, {1, 2}};
  given.exchange(kept);
  EXPECT_FALSE(given.is_finer(added[3], 0.9));
  EXPECT_TRUE(given.is_finer(added[3], 1));
  given.exchange(kept);
  EXPECT_EQ(kept.edges, (std::vector<float>{1, 2}));

  const SurfacePatch patch = coarsen_surface(fine, added, {.edge = 0.2, .apart = 0.001});
  ASSERT_GT(patch.removed.size(), 100u);
  std::vector<Index> corners;
  for (const Index triangle : patch.removed)
    corners.insert(corners.end(), fine.triangles[triangle].begin(), fine.triangles[triangle].end());
  sort_unique(corners);
  const auto [coarse, left] = patched(fine, patch);
  const GivenShape after = given.coarsened(coarse, left, corners), anew(coarse);
  for (Index v = 0; v < coarse.vertex_count(); ++v) {
    EXPECT_EQ(after.is_refined(v), given.is_refined(left[v]));
    EXPECT_EQ(after.gap(v), std::ranges::binary_search(corners, left[v]) ? anew.gap(v) : given.gap(left[v]));
  }
}

// A plane is drawn out into a ridge with slopes of 3, and refined along that. As it was given it needs a few
// triangles; as it is now it would need about three times as many.
TEST(GivenShape, KeepsWhatWasDrawnFromLookingCoarse) {
  Surface surface = make_surface(grid(20, 0.05F));
  GivenShape given(surface);
  given.keep_positions(surface);
  for (Vec3f& p : surface.positions) p.z() = std::max(0.F, 0.6F - 3 * std::abs(p.y() - 0.5F));
  given.keep_positions(surface);  // what is kept already stays
  const EdgeLength lengths({straight({0.2, 0.5, 0.6}, {0.8, 0.5, 0.6})}, 0.4, 0.02);
  std::vector<Index> seeds(surface.triangles.size());
  for (Index i = 0; i < seeds.size(); ++i) seeds[i] = i;
  const Patched made(surface, given, lengths, seeds), stretched(surface, GivenShape(surface), lengths, seeds);
  EXPECT_LT(2 * made.made.patch.triangles.size(), stretched.made.patch.triangles.size());
  const GivenShape refined =
      given.patched(made.after.surface, made.after.came_from, {made.made.given, made.made.edges});
  const std::span<const Vec3f> flat = refined.positions(made.after.surface);
  const Surface& after = made.after.surface;
  std::size_t fresh = 0, within = 0;
  for (Index v = 0; v < after.vertex_count(); ++v) {
    EXPECT_EQ(flat[v].z(), 0);
    if (!made.is_new(v, surface)) continue;
    ++fresh;
    EXPECT_LT((flat[v] - after.positions[v]).head<2>().norm(), 0.01);
    if (lengths.at(after.positions[v].cast<double>()) > lengths.edge()) continue;
    ++within;
    EXPECT_LE(refined.gap(v), 0.02 * longest_edge_factor + 1e-6);
  }
  EXPECT_GT(fresh, 300u);
  EXPECT_GT(within, 100u);
  EXPECT_TRUE(refine_surface(after, lengths, seeds, 100'000, flat).patch.triangles.empty());
}

}  // namespace
}  // namespace burin::test
