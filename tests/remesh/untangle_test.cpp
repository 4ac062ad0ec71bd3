#include <burin/remesh/intersection.h>
#include <burin/remesh/untangle.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

TEST(Untangle, KeepsMovesThatDoNoHarm) {
  PatchMesh patch = test::flat_patch(6);
  const std::vector<Vec3d> before = patch.positions;
  for (Vec3d& p : patch.positions) p += Vec3d(0.2, 0, 0.1 * p.x() * p.y());
  const std::vector<Vec3d> moved = patch.positions;
  untangle(patch, before);
  EXPECT_EQ(patch.positions, moved);
}

TEST(Untangle, TakesBackWhatTurnsTrianglesOver) {
  PatchMesh patch = test::flat_patch(6);
  const std::vector<Vec3d> before = patch.positions;
  const Index turning = 3 * 7 + 3, harmless = 1 * 7 + 5;
  patch.positions[turning] += Vec3d(1.7, 0.4, 0);
  patch.positions[harmless] += Vec3d(0.2, 0.1, 0);
  untangle(patch, before);
  EXPECT_EQ(patch.positions[turning], before[turning]);
  EXPECT_EQ(patch.positions[harmless], Vec3d(before[harmless] + Vec3d(0.2, 0.1, 0)));
  for (const auto& [a, b, c] : patch.triangles)
    EXPECT_GT((patch.positions[b] - patch.positions[a]).cross(patch.positions[c] - patch.positions[a]).z(),
              0);
}

// Two sheets; a vertex of the lower one is moved through the upper one.
TEST(Untangle, TakesBackWhatGoesThroughOthers) {
  PatchMesh patch = test::flat_patch(4);
  const PatchMesh above = test::flat_patch(4);
  const Index offset = patch.vertex_count();
  for (const Vec3d& p : above.positions) patch.positions.push_back(p + Vec3d(0.3, 0.3, 0.5));
  for (const auto& [a, b, c] : above.triangles)
    patch.triangles.push_back({a + offset, b + offset, c + offset});
  patch.kept.resize(patch.positions.size(), no_index);
  const std::vector<Vec3d> before = patch.positions;
  patch.positions[2 * 5 + 2].z() = 0.8;
  patch.positions[0].z() = 0.1;
  ASSERT_FALSE(crossing_triangles(patch).empty());
  untangle(patch, before);
  EXPECT_TRUE(crossing_triangles(patch).empty());
  EXPECT_EQ(patch.positions[2 * 5 + 2], before[2 * 5 + 2]);
  EXPECT_EQ(patch.positions[0].z(), 0.1);
}

}  // namespace
}  // namespace burin
