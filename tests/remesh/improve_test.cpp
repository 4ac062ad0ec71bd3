#include <burin/base/error.h>
#include <burin/remesh/edge_mesh.h>
#include <burin/remesh/improve.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

bool everywhere(const Vec3d&) { return true; }
bool nowhere(const Vec3d&) { return false; }

/// Its inner vertices moved at random, some nearly onto each other.
PatchMesh shaken() {
  constexpr std::uint32_t seed = 5;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  PatchMesh patch = test::flat_patch(12);
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    if (!patch.is_fixed(v)) patch.positions[v] += 0.9 * Vec3d(share(), share(), 0);
  }
  return patch;
}

Improvement flat(double size) {
  return {.size = [size](const Vec3d&) { return size; },
          .bring = [](const Vec3d& p) { return Vec3d(p.x(), p.y(), 0); },
          .crease = nowhere,
          .smooth = everywhere};
}

TEST(Improve, WidensSmallAngles) {
  PatchMesh patch = shaken();
  ASSERT_LT(std::ranges::min(least_angles(patch)), 10) << "the sample has no small angles";
  improve(patch, flat(1));
  EXPECT_GE(std::ranges::min(least_angles(patch)), 25);
  EXPECT_NEAR(test::twice_area(patch), 2 * 144, 1e-9);
  EXPECT_EQ(test::border_sides(patch), 48);
}

TEST(Improve, GivesEdgesTheSize) {
  PatchMesh patch = test::flat_patch(12);
  const std::size_t before = patch.triangles.size();
  improve(patch, flat(0.5));
  EXPECT_GT(patch.triangles.size(), 2 * before);
}

TEST(Improve, KeepsFixedVertices) {
  PatchMesh patch = shaken();
  improve(patch, flat(1));
  const PatchMesh before = test::flat_patch(12);
  std::size_t fixed = 0;
  for (Index v = 0; v < patch.vertex_count(); ++v)
    if (patch.is_fixed(v)) {
      ++fixed;
      EXPECT_EQ(patch.positions[v], before.positions[patch.kept[v]]);
    }
  EXPECT_EQ(fixed, 48u);
}

// A strip of triangles whose corners all are on the border, beside edges that are far too short: collapsing
// these must not leave ears along the border.
TEST(Improve, LeavesNoEarsOnTheBorder) {
  PatchMesh patch = test::flat_patch(24);
  improve(patch, flat(5));
  EXPECT_GE(std::ranges::min(least_angles(patch)), 15);
  EXPECT_LT(patch.triangles.size(), 24u * 24);
  EXPECT_EQ(test::border_sides(patch), 96);
}

// Edges from a vertex that stays to all of a row of small triangles are not halved again and again.
TEST(Improve, GradesEdgesTowardsFineTriangles) {
  PatchMesh patch = test::flat_patch(12);
  Improvement how = flat(1);
  const auto from_middle = [](const Vec3d& p) { return std::hypot(p.x() - 6, p.y() - 6); };
  how.size = [&](const Vec3d& p) { return std::max(0.15, 0.5 * from_middle(p)); };
  how.smooth = [&](const Vec3d& p) { return from_middle(p) < 1; };
  improve(patch, how);
  EXPECT_GE(std::ranges::min(least_angles(patch)), 15);
  EXPECT_GT(patch.triangles.size(), 350u);
}

// A roof: its ridge, at x = 6, stays sharp.
TEST(Improve, LeavesCreasesWhereTheyAre) {
  PatchMesh patch = shaken();
  const auto height = [](double x) { return 6 - std::abs(x - 6); };
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (v / 13 == 6) patch.positions[v].x() = 6;
    patch.positions[v].z() = height(patch.positions[v].x());
  }
  Improvement how = flat(1);
  how.bring = [&](const Vec3d& p) { return Vec3d(p.x(), p.y(), height(p.x())); };
  how.crease = [](const Vec3d& p) { return std::abs(p.x() - 6) < 1e-9; };
  improve(patch, how);
  for (const auto& [a, b, c] : patch.triangles) {
    const double x[] = {patch.positions[a].x() - 6, patch.positions[b].x() - 6, patch.positions[c].x() - 6};
    EXPECT_GE(*std::ranges::min_element(x) * *std::ranges::max_element(x), -1e-9)
        << "a triangle cuts the ridge";
  }
}

TEST(EdgeMesh, RefusesWhatIsNoManifold) {
  const PatchMesh fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                      std::vector<Index>(5, no_index)};
  EXPECT_THROW(to_edges(fan), Error);
}

}  // namespace
}  // namespace burin
