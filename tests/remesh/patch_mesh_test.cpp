#include <burin/remesh/patch_mesh.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(PatchMesh, LosesUnusedVerticesAndKeepsTheOrder) {
  const PatchMesh patch{
      {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {8, 8, 8}}, {{0, 2, 3}}, {no_index, 5, 7, no_index, 6}};
  const PatchMesh left = without_unused_vertices(patch);
  EXPECT_EQ(left.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(left.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(left.kept, (std::vector<Index>{no_index, 7, no_index}));
}

}  // namespace
}  // namespace burin
