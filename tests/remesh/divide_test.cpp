#include <burin/remesh/divide.h>
#include <gtest/gtest.h>

#include <numbers>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

using test::same;

double beyond_circle(const Vec3d& p) { return (p - Vec3d(4, 4, 0)).norm() - 2.3; }

TEST(Divide, KeepsWhatIsAboveZero) {
  const PatchMesh patch = kept_part(divide(
      test::flat_patch(8), [](const Vec3d& p) { return p.x() - 2.25; }, same));
  EXPECT_NEAR(test::twice_area(patch), 2 * 5.75 * 8, 1e-9);
}

TEST(Divide, CutsAHoleWhoseBorderIsOnTheLine) {
  const PatchMesh patch = kept_part(divide(test::flat_patch(8), beyond_circle, same));
  EXPECT_NEAR(test::twice_area(patch), 2 * (64 - std::numbers::pi * 2.3 * 2.3), 0.7);
  EXPECT_GT(test::border_sides(patch), 32);
  for (std::size_t v = 0; v < patch.positions.size(); ++v)
    EXPECT_GE(beyond_circle(patch.positions[v]), -1e-9);
}

TEST(Cut, SplitsWithoutRemoving) {
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

TEST(Divide, KeepsTheNumbersOfFixedVertices) {
  PatchMesh patch = test::flat_patch(8);
  const PatchMesh before = patch;
  patch = kept_part(divide(patch, beyond_circle, same));
  for (std::size_t v = 0; v < patch.positions.size(); ++v)
    if (patch.is_fixed(static_cast<Index>(v))) {
      EXPECT_EQ(patch.positions[v], before.positions[patch.kept[v]]);
    }
}

TEST(Divide, TellsTheSideOfEachTriangle) {
  const DividedPatch divided = divide(test::flat_patch(8), beyond_circle, same);
  ASSERT_EQ(divided.kept.size(), divided.patch.triangles.size());
  ASSERT_EQ(divided.field.size(), divided.patch.positions.size());
  EXPECT_NEAR(test::twice_area(divided.patch), 128, 1e-9);
  for (std::size_t t = 0; t < divided.kept.size(); ++t) {
    Vec3d middle = Vec3d::Zero();
    for (const Index v : divided.patch.triangles[t]) middle += divided.patch.positions[v] / 3;
    // Chords of the circle lie within it.
    if (divided.kept[t]) {
      EXPECT_GT(beyond_circle(middle), -0.15);
    } else {
      EXPECT_LT(beyond_circle(middle), 0);
    }
  }
}

}  // namespace
}  // namespace burin
