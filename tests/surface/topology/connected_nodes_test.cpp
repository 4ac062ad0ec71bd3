#include <burin/surface/topology/connected_nodes.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace burin {
namespace {

/// Nodes in a row, each joined with the next.
Csr chain(Index count) {
  Csr graph;
  graph.offsets.push_back(0);
  for (Index node = 0; node < count; ++node) {
    if (node > 0) graph.items.push_back(node - 1);
    if (node + 1 < count) graph.items.push_back(node + 1);
    graph.offsets.push_back(static_cast<Index>(graph.items.size()));
  }
  return graph;
}

TEST(ConnectedNodes, EndWhereTheKindEnds) {
  const Csr graph = chain(100);
  ConnectedNodes connected;
  const auto found =
      connected.find(graph, std::array<Index, 2>{10, 11}, [](Index node) { return node != 7 && node != 13; });
  EXPECT_EQ(std::vector<Index>(found.begin(), found.end()), (std::vector<Index>{10, 11, 9, 12, 8}));
}

TEST(ConnectedNodes, CountTheStartsWhateverTheyAre) {
  const Csr graph = chain(5);
  ConnectedNodes connected;
  const auto found = connected.find(graph, std::array<Index, 1>{2}, [](Index) { return false; });
  EXPECT_EQ(std::vector<Index>(found.begin(), found.end()), (std::vector<Index>{2}));
}

TEST(ConnectedNodes, AreTheNearestWhereThereAreTooMany) {
  const Csr graph = chain(100000);
  ConnectedNodes connected;
  const auto found = connected.find(graph, std::array<Index, 1>{50000}, [](Index) { return true; });
  EXPECT_GT(found.size(), 1000U);
  EXPECT_LT(found.size(), 5000U);
  for (const Index node : found) EXPECT_LT(node > 50000 ? node - 50000 : 50000 - node, 2500U);
}

}  // namespace
}  // namespace burin
