#include <burin/surface/topology/vertex_star.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(VertexStar, JoinsFacesAcrossTheirEdges) {
  VertexStar star;
  star.add(10, 1, 2);
  star.add(11, 2, 3);
  star.add(12, 5, 4);
  star.connect();
  EXPECT_EQ(star.fans(), 2);
  ASSERT_EQ(star.edges().size(), 5u);
  const StarEdge& shared = star.edges()[1];
  EXPECT_EQ(shared.other, 2u);
  EXPECT_EQ(shared.faces(), 2);
  EXPECT_FALSE(shared.flipped());
  EXPECT_EQ(std::minmax(shared.face, shared.other_face), std::minmax(Index{10}, Index{11}));
}

TEST(VertexStar, TellsFlippedFacesAndEdgesOfMany) {
  VertexStar star;
  star.add(0, 1, 2);
  star.add(1, 3, 2);
  star.connect();
  EXPECT_TRUE(star.edges()[1].flipped());
  star.add(2, 2, 4);
  star.connect();
  EXPECT_EQ(star.edges()[1].faces(), 3);
  EXPECT_FALSE(star.edges()[1].flipped());
  EXPECT_EQ(star.fans(), 1);
  star.clear();
  star.connect();
  EXPECT_EQ(star.fans(), 0);
  EXPECT_TRUE(star.edges().empty());
}

}  // namespace
}  // namespace burin
