#include <burin/remesh/divide.h>
#include <burin/remesh/join.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

using test::same;

/// The square without a disc, and the disc out of a square of other triangles.
struct Parts {
  PatchMesh outer = test::flat_patch(8), inner = finer();

  static PatchMesh finer() {
    PatchMesh patch = test::flat_patch(15);
    for (Vec3d& p : patch.positions) p = 0.6 * p - Vec3d(0.5, 0.5, 0);
    patch.kept.assign(patch.kept.size(), no_index);
    return patch;
  }

  explicit Parts(double radius, double other_radius) {
    const auto beyond = [](double r) {
      return [r](const Vec3d& p) { return (p - Vec3d(4, 4, 0)).norm() - r; };
    };
    outer = kept_part(divide(outer, beyond(radius), same));
    inner = kept_part(divide(
        inner, [&](const Vec3d& p) { return -beyond(other_radius)(p); }, same));
  }
};

TEST(Join, MakesOnePatchWithoutACrack) {
  const Parts parts(2.3, 2.3);
  const std::optional<PatchMesh> joined = join(parts.outer, parts.inner, 0.3);
  ASSERT_TRUE(joined);
  EXPECT_EQ(test::border_sides(*joined), 32);
  EXPECT_NEAR(test::twice_area(*joined), 128, 1e-3);
  for (std::size_t v = 0; v < joined->positions.size(); ++v)
    if (joined->is_fixed(static_cast<Index>(v))) {
      EXPECT_EQ(joined->positions[v], test::flat_patch(8).positions[joined->kept[v]]);
    }
}

TEST(Join, RefusesBordersThatAreTooFarApart) {
  const Parts parts(2.3, 1.9);
  EXPECT_FALSE(join(parts.outer, parts.inner, 0.3));
}

TEST(Join, RefusesAHoleThatNothingFills) {
  const Parts parts(2.3, 2.3);
  EXPECT_FALSE(join(parts.outer, PatchMesh{}, 0.3));
}

}  // namespace
}  // namespace burin
