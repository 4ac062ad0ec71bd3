#include <burin/level_set/relaxed_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/rods.h"
#include "support/shapes.h"

namespace burin {
namespace {

void to_sphere(std::vector<Vec3f>& positions) {
  for (Vec3f& p : positions) p.normalize();
}

// Vertices of the mesh are moved by up to 0.9 edges from where they should be.
TEST(RelaxedMesh, SpreadsVerticesEvenlyOverASphere) {
  TriangleMesh mesh = test::sphere(4, 0.9, 3);
  const double before = test::angles_of(mesh)[0];
  relax(mesh, to_sphere);
  EXPECT_LT(before, 10);
  EXPECT_GT(test::angles_of(mesh)[0], 20);
}

TEST(RelaxedMesh, HoldsTheVolumeOfTheSurface) {
  const double exact = 4 * std::numbers::pi / 3;
  for (const int levels : {3, 4}) {
    TriangleMesh mesh = test::sphere(levels, 0.3, 3);
    const double missing = 1 - test::extent_of(mesh).volume / exact;
    relax(mesh, to_sphere);
    EXPECT_LT(std::abs(1 - test::extent_of(mesh).volume / exact), missing / 20);
  }
}

}  // namespace
}  // namespace burin
