#include <burin/remesh/clip.h>
#include <gtest/gtest.h>

#include <numbers>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

Vec3d same(const Vec3d& p) { return p; }

double beyond_circle(const Vec3d& p) { return (p - Vec3d(4, 4, 0)).norm() - 2.3; }

TEST(Clip, LeavesWhatIsAboveZero) {
  PatchMesh patch = test::flat_patch(8);
  clip(
      patch, [](const Vec3d& p) { return p.x() - 2.25; }, same);
  EXPECT_NEAR(test::twice_area(patch), 2 * 5.75 * 8, 1e-9);
}

TEST(Clip, CutsAHoleWhoseBorderIsOnTheLine) {
  PatchMesh patch = test::flat_patch(8);
  clip(patch, beyond_circle, same);
  EXPECT_NEAR(test::twice_area(patch), 2 * (64 - std::numbers::pi * 2.3 * 2.3), 0.7);
  EXPECT_GT(test::border_sides(patch), 32);
  for (std::size_t v = 0; v < patch.positions.size(); ++v)
    EXPECT_GE(beyond_circle(patch.positions[v]), -1e-9);
}

TEST(Clip, CutsWithoutRemoving) {
  PatchMesh patch = test::flat_patch(8);
  const std::vector<double> value = cut(patch, beyond_circle, same);
  ASSERT_EQ(value.size(), patch.positions.size());
  EXPECT_NEAR(test::twice_area(patch), 128, 1e-9);
  EXPECT_EQ(test::border_sides(patch), 32);
  for (const Triangle& t : patch.triangles) {
    const double product =
        std::min({value[t[0]], value[t[1]], value[t[2]]}) * std::max({value[t[0]], value[t[1]], value[t[2]]});
    EXPECT_GE(product, 0) << "a triangle reaches over the line";
  }
}

TEST(Clip, KeepsTheNumbersOfFixedVertices) {
  PatchMesh patch = test::flat_patch(8);
  const PatchMesh before = patch;
  clip(patch, beyond_circle, same);
  for (std::size_t v = 0; v < patch.positions.size(); ++v)
    if (patch.is_fixed(static_cast<Index>(v))) {
      EXPECT_EQ(patch.positions[v], before.positions[patch.kept[v]]);
    }
}

}  // namespace
}  // namespace burin
