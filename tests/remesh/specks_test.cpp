#include <burin/remesh/specks.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

/// Adds a tetrahedron with legs of this length, its sides outward or inward.
void add_tetrahedron(PatchMesh& patch, double leg, bool outward) {
  const Index first = patch.vertex_count();
  for (const Vec3d& p : {Vec3d(0, 0, 5), Vec3d(leg, 0, 5), Vec3d(0, leg, 5), Vec3d(0, 0, 5 + leg)}) {
    patch.positions.push_back(p);
    patch.kept.push_back(no_index);
  }
  for (auto [a, b, c] : {Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    if (!outward) std::swap(b, c);
    patch.triangles.push_back({first + a, first + b, first + c});
  }
}

TEST(Specks, AreRemovedAndHollowsToo) {
  for (const bool outward : {true, false}) {
    PatchMesh patch = test::flat_patch(3);
    add_tetrahedron(patch, 0.5, outward);
    add_tetrahedron(patch, 3, outward);
    // Volumes of 0.02 and 4.5.
    remove_specks(patch, 1);
    EXPECT_EQ(patch.triangles.size(), 18u + 4u);
    EXPECT_EQ(patch.positions.size(), 16u + 4u);
    EXPECT_EQ(test::border_sides(patch), 12);
  }
}

TEST(Specks, StayWhereTheyHaveABorder) {
  PatchMesh patch = test::flat_patch(3);
  patch.kept.assign(patch.kept.size(), no_index);
  remove_specks(patch, 1);
  EXPECT_EQ(patch.triangles.size(), 18u);
}

}  // namespace
}  // namespace burin
