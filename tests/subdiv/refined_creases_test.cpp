#include <burin/subdiv/refined_creases.h>
#include <gtest/gtest.h>

#include <cmath>

#include "subdiv/cages.h"

namespace burin::test {
namespace {

TEST(RefinedCreases, AreTheLinesOfTheCageOnTheRefinedMesh) {
  // A sharp crease along x = 1 stays straight, and each level doubles its edges.
  PolygonMesh cage = plate(4);
  for (Index y = 0; y < 4; ++y) cage.creases.push_back({(y + 1) * 5 + 1, y * 5 + 1, 10});
  cage.creases.push_back({7, 8, 0});
  for (const int level : {0, 1, 3}) {
    const TriangleMesh mesh = refine(cage, SubdivisionScheme::catmull_clark, level);
    const auto edges = refined_creases(cage, SubdivisionScheme::catmull_clark, level);
    EXPECT_EQ(edges.size(), std::size_t{4} << level) << "an edge without sharpness is no crease";
    EXPECT_TRUE(std::ranges::is_sorted(edges));
    double length = 0;
    for (const auto& [a, b] : edges) {
      EXPECT_LT(a, b);
      EXPECT_NEAR(mesh.positions[a].x(), 1, 1e-6);
      EXPECT_NEAR(mesh.positions[b].x(), 1, 1e-6);
      length += static_cast<double>((mesh.positions[b] - mesh.positions[a]).norm());
    }
    EXPECT_NEAR(length, 4, 1e-5);
  }
}

TEST(RefinedCreases, AreNoneWithoutCreases) {
  EXPECT_TRUE(refined_creases(tetrahedron(), SubdivisionScheme::loop, 2).empty());
}

}  // namespace
}  // namespace burin::test
