#include <burin/deform/stroke_changes.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace burin {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

struct Node {
  double t;
  float d;
  Vec3f e1;
  NodePen pen;
};

StrokeNodes nodes_of(const std::map<Index, Node>& nodes) {
  StrokeNodes result;
  for (const auto& [vertex, node] : nodes) {
    result.chart.vertex.push_back(vertex);
    result.chart.t.push_back(node.t);
    result.chart.d.push_back(node.d);
    result.chart.e1.push_back(node.e1);
    result.pen.push_back(node.pen);
  }
  return result;
}

TEST(StrokeChanges, FindsEveryKindOfChange) {
  const Node same{1, 0.5f, Vec3f::UnitX(), {}};
  Node other_t = same, other_d = same, other_e1 = same, other_pen = same;
  other_t.t = 1 + 1e-15;
  other_d.d = 0.6f;
  other_e1.e1 = Vec3f::UnitY();
  other_pen.pen.tilt_y = 0.1f;
  const std::map<Index, Node> before = {{1, same}, {2, same}, {3, same}, {4, same},
                                        {5, same}, {8, same}, {9, same}};
  const std::map<Index, Node> now = {{0, same},     {1, same},      {2, other_t}, {3, other_d},
                                     {4, other_e1}, {5, other_pen}, {6, same}};
  const StrokeChanges changes = find_changes(nodes_of(before), nodes_of(now), nowhere);
  EXPECT_EQ(changes.stale, (std::vector<Index>{0, 2, 3, 4, 5, 6}));
  EXPECT_EQ(changes.left, (std::vector<Index>{8, 9}));
}

TEST(StrokeChanges, TakesTheEndZoneAnew) {
  std::map<Index, Node> nodes;
  for (Index vertex = 0; vertex < 5; ++vertex)
    nodes[vertex] = {static_cast<double>(vertex), 0, Vec3f::UnitX(), {}};
  const StrokeNodes stroke = nodes_of(nodes);
  EXPECT_EQ(find_changes(stroke, stroke, 3).stale, (std::vector<Index>{3, 4}));
  EXPECT_EQ(find_changes(stroke, stroke, -nowhere).stale.size(), 5u);
  EXPECT_EQ(nodes_from(stroke.chart, 3), (std::vector<Index>{3, 4}));
}

TEST(StrokeChanges, AgreesWithALookupVertexByVertex) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::size_t seen_stale = 0, seen_left = 0, seen_kept = 0;
  for (int round = 0; round < 200; ++round) {
    std::map<Index, Node> before, now;
    for (Index vertex = 0; vertex < 30; ++vertex) {
      const Node node{static_cast<double>(random() % 4), 0, Vec3f::UnitX(), {}};
      if (random() % 3) before[vertex] = node;
      if (random() % 3) now[vertex] = random() % 2 ? node : Node{node.t + 1, 0, Vec3f::UnitX(), {}};
    }
    std::vector<Index> stale, left;
    Index index = 0;
    for (const auto& [vertex, node] : now) {
      if (!before.count(vertex) || before[vertex].t != node.t || node.t >= 4) stale.push_back(index);
      ++index;
    }
    for (const auto& [vertex, node] : before)
      if (!now.count(vertex)) left.push_back(vertex);
    const StrokeChanges changes = find_changes(nodes_of(before), nodes_of(now), 4);
    ASSERT_EQ(changes.stale, stale);
    ASSERT_EQ(changes.left, left);
    seen_stale += stale.size();
    seen_left += left.size();
    seen_kept += now.size() - stale.size();
  }
  EXPECT_GT(seen_stale, 500u);
  EXPECT_GT(seen_left, 500u);
  EXPECT_GT(seen_kept, 500u);
}

}  // namespace
}  // namespace burin
