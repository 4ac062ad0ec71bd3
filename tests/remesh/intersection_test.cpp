#include <burin/remesh/intersection.h>
#include <gtest/gtest.h>

#include "remesh/flat_patch.h"

namespace burin {
namespace {

void add_triangle(PatchMesh& patch, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Index first = patch.vertex_count();
  for (const Vec3d& p : {a, b, c}) {
    patch.positions.push_back(p);
    patch.kept.push_back(no_index);
  }
  patch.triangles.push_back({first, first + 1, first + 2});
}

TEST(CrossingTriangles, AreFound) {
  PatchMesh patch = test::flat_patch(20);
  EXPECT_TRUE(crossing_triangles(patch).empty());
  add_triangle(patch, {5.3, 5.2, 0.1}, {5.4, 5.6, 1}, {5.9, 5.1, 1});
  EXPECT_TRUE(crossing_triangles(patch).empty()) << "above";
  add_triangle(patch, {12.3, 7.2, -0.1}, {12.4, 7.6, 1}, {12.9, 7.1, 1});
  const std::vector<Index> crossing = crossing_triangles(patch);
  // The last one, and what it goes through.
  ASSERT_GE(crossing.size(), 2u);
  EXPECT_EQ(crossing.back(), patch.triangles.size() - 1);
  for (const Index t : crossing)
    EXPECT_LT((patch.positions[patch.triangles[t][0]] - Vec3d(12.3, 7.2, 0)).norm(), 1.5);
}

// A fan that is folded over: triangles that share the middle go through each other.
TEST(CrossingTriangles, AreFoundAroundAVertex) {
  PatchMesh patch{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.6, -0.5}, {0.9, 0.2, 0.5}},
                  {{0, 1, 2}, {0, 3, 4}},
                  std::vector<Index>(5, no_index)};
  EXPECT_EQ(crossing_triangles(patch), (std::vector<Index>{0, 1}));
  patch.positions[3].z() = 0.1;
  EXPECT_TRUE(crossing_triangles(patch).empty());
}

// A plane in a direction in which coordinates have to be rounded.
TEST(CrossingTriangles, AreNoneInAPlane) {
  PatchMesh patch = test::flat_patch(20);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized()));
  for (Vec3d& p : patch.positions) p = turn * Vec3d(0.1 * p.x() + 5, 0.1 * p.y() + 7, 3);
  EXPECT_TRUE(crossing_triangles(patch).empty());
}

TEST(CrossingTriangles, AreNoneWhereTrianglesTouch) {
  PatchMesh patch = test::flat_patch(4);
  add_triangle(patch, {1.3, 1.2, 0}, {1.4, 1.6, 1}, {1.9, 1.1, 1});
  EXPECT_TRUE(crossing_triangles(patch).empty());
  EXPECT_TRUE(crossing_triangles({}).empty());
}

}  // namespace
}  // namespace burin
