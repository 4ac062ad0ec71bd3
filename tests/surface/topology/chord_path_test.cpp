#include <burin/surface/picker.h>
#include <burin/surface/topology/chord_path.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace burin {
namespace {

struct Ground {
  explicit Ground(TriangleMesh mesh) : surface(make_surface(std::move(mesh))) {}

  bool joins(const Vec3f& from, const Vec3f& to, double reach) const {
    return has_path_near_chord(surface, *picker.closest(from, 1), *picker.closest(to, 1), reach);
  }

  Surface surface;
  Picker picker{surface};
};

/// The plane z = 0 with a groove along y, 1 wide and 0.3 deep. The edges at its bottom lie below -0.24.
TriangleMesh grooved() {
  return test::patch({-1, 1, -1, 1, 20, 20, false, 0, 0.3},
                     [](double u, double v) { return Vec3d(u, v, std::min(0.0, 0.6 * std::abs(u) - 0.3)); });
}

TEST(ChordPath, GoesAsFarFromTheChordAsItMay) {
  const Ground ground(grooved());
  EXPECT_TRUE(ground.joins(Vec3f(-0.55F, 0.03F, 0), Vec3f(0.55F, 0.01F, 0), 0.301));
  EXPECT_FALSE(ground.joins(Vec3f(-0.55F, 0.03F, 0), Vec3f(0.55F, 0.01F, 0), 0.2));
}

TEST(ChordPath, CrossesEdgesWhoseEndsAreFar) {
  TriangleMesh roof;  // two faces at a right angle that meet in the line from (0, -9, 0) to (0, 9, 0)
  roof.positions = {{0, -9, 0}, {0, 9, 0}, {-9, 0, -9}, {9, 0, -9}};
  roof.triangles = {{0, 1, 2}, {0, 3, 1}};
  const Ground ground(roof);
  const Vec3f left(-0.2F, 0, -0.2F), right(0.2F, 0, -0.2F);
  EXPECT_TRUE(ground.joins(left, right, 0.201));
  EXPECT_FALSE(ground.joins(left, right, 0.199));
}

TEST(ChordPath, CrossesNoGap) {
  TriangleMesh two = test::plane(1, 0.1, 1);
  const auto count = static_cast<Index>(two.positions.size());
  const TriangleMesh upper = two;
  for (const Vec3f& p : upper.positions) two.positions.emplace_back(p + Vec3f(0, 0, 0.01F));
  for (const auto& [a, b, c] : upper.triangles) two.triangles.push_back({a + count, b + count, c + count});
  const Ground ground(two);
  EXPECT_FALSE(ground.joins(Vec3f(0, 0, 0), Vec3f(0, 0, 0.01F), 9));
  EXPECT_TRUE(ground.joins(Vec3f(0, 0, 0), Vec3f(0.5F, 0, 0), 0.1));
}

}  // namespace
}  // namespace burin
