#include <burin/remesh/improve.h>
#include <burin/remesh/refine.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

/// Small around the middle of a square of 8 x 8.
double size(const Vec3d& p) { return 0.3 + 0.4 * (p - Vec3d(4, 4, 0)).norm(); }

TEST(Refine, HalvesEdgesUntilNoneIsTooLong) {
  PatchMesh patch = test::flat_patch(8);
  refine(patch, size);
  EXPECT_NEAR(test::twice_area(patch), 128, 1e-9);
  EXPECT_EQ(test::border_sides(patch), 32);
  for (const Triangle& t : patch.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d &a = patch.positions[t[i]], &b = patch.positions[t[(i + 1) % 3]];
      const bool at_border = patch.is_fixed(t[0]) || patch.is_fixed(t[1]) || patch.is_fixed(t[2]);
      if (!at_border) {
        EXPECT_LE((b - a).norm(), least_size(size, a, b)) << a.transpose();
      }
    }
}

// Bisection of the longest side halves the least angle at most.
TEST(Refine, KeepsAngles) {
  PatchMesh patch = test::flat_patch(8);
  refine(patch, size);
  EXPECT_GE(std::ranges::min(least_angles(patch)), 22.4);
}

// Its longest sides cannot be halved, so that there would be no end.
TEST(Refine, LeavesATriangleOfTheBorderAlone) {
  PatchMesh patch{{{0, 0, 0}, {9, 0, 0}, {4, 5, 0}}, {{0, 1, 2}}, {0, 1, 2}};
  refine(patch, [](const Vec3d&) { return 0.1; });
  EXPECT_EQ(patch.triangles.size(), 1u);
}

}  // namespace
}  // namespace burin
