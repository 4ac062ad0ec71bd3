#include <burin/abi/stroke.h>
#include <burin/deform/stroke_changes.h>
#include <gtest/gtest.h>

#include <algorithm>
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

using Nodes = std::multimap<Index, Node>;  // sheets of a vertex in this order

StrokeNodes nodes_of(const Nodes& nodes) {
  StrokeNodes result;
  Chart& chart = result.chart;
  for (const auto& [vertex, node] : nodes) {
    chart.sheet.push_back(!chart.vertex.empty() && chart.vertex.back() == vertex ? chart.sheet.back() + 1
                                                                                 : 0);
    chart.vertex.push_back(vertex);
    chart.t.push_back(node.t);
    chart.d.push_back(node.d);
    chart.e1.push_back(node.e1);
    chart.stretch.push_back(1);
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
  const Nodes before = {{1, same}, {2, same}, {3, same}, {4, same}, {5, same}, {8, same}, {9, same}};
  const Nodes now = {{0, same},     {1, same},      {2, other_t}, {3, other_d},
                     {4, other_e1}, {5, other_pen}, {6, same}};
  const StrokeChanges changes = find_changes(nodes_of(before), nodes_of(now), nowhere, 0);
  EXPECT_EQ(changes.stale, (std::vector<Index>{0, 2, 3, 4, 5, 6}));
  EXPECT_EQ(changes.altered, changes.stale);
  EXPECT_EQ(changes.before,
            (std::vector<Index>{no_index, 0, no_index, no_index, no_index, no_index, no_index}));
  EXPECT_EQ(changes.left, (std::vector<Index>{8, 9}));
}

TEST(StrokeChanges, TakesTheEndZoneAnew) {
  Nodes nodes;
  for (Index vertex = 0; vertex < 5; ++vertex)
    nodes.insert({vertex, {static_cast<double>(vertex), 0, Vec3f::UnitX(), {}}});
  const StrokeNodes stroke = nodes_of(nodes);
  EXPECT_EQ(find_changes(stroke, stroke, 3, 0).stale, (std::vector<Index>{3, 4}));
  EXPECT_EQ(find_changes(stroke, stroke, -nowhere, 0).stale.size(), 5u);
}

TEST(StrokeChanges, KnowsASheetWhenOneAppearsBeforeIt) {
  const Node early{1, 0, Vec3f::UnitX(), {}}, late{5, 0, Vec3f::UnitX(), {}};
  const StrokeNodes one = nodes_of({{3, late}, {4, late}}),
                    two = nodes_of({{3, early}, {3, late}, {4, late}});
  const StrokeChanges grown = find_changes(one, two, nowhere, BURIN_INPUT_T);
  EXPECT_EQ(grown.stale, (std::vector<Index>{0}));
  EXPECT_EQ(grown.before, (std::vector<Index>{no_index, 0, 1}));
  EXPECT_EQ(grown.altered, (std::vector<Index>{0}));
  const StrokeChanges shrunk = find_changes(two, one, nowhere, BURIN_INPUT_T);
  EXPECT_TRUE(shrunk.stale.empty());
  EXPECT_EQ(shrunk.before, (std::vector<Index>{1, 2}));
  EXPECT_EQ(shrunk.altered, (std::vector<Index>{0})) << "one node less to blend";
  EXPECT_TRUE(shrunk.left.empty());
}

TEST(StrokeChanges, CountsSheetsAnewForBrushesThatReadThem) {
  const Node early{1, 0, Vec3f::UnitX(), {}}, late{5, 0, Vec3f::UnitX(), {}}, last{7, 0, Vec3f::UnitX(), {}};
  const StrokeNodes before = nodes_of({{3, late}, {4, early}});
  const StrokeNodes now = nodes_of({{3, early}, {3, late}, {4, early}, {4, last}});
  EXPECT_EQ(find_changes(before, now, nowhere, BURIN_INPUT_SHEET).stale, (std::vector<Index>{0, 1, 3}));
  EXPECT_EQ(find_changes(before, now, nowhere, BURIN_INPUT_VISIT_COUNT).stale.size(), 4u);
}

/// The same by comparing each node with each of its vertex.
StrokeChanges looked_up(const StrokeNodes& before, const StrokeNodes& now, double end_zone) {
  StrokeChanges changes;
  const Chart &old = before.chart, &chart = now.chart;
  for (Index j = 0; j < chart.size(); ++j) {
    Index found = no_index;
    for (Index i = 0; i < old.size() && chart.t[j] < end_zone; ++i)
      if (old.vertex[i] == chart.vertex[j] && old.t[i] == chart.t[j]) found = i;
    changes.before.push_back(found);
    if (found == no_index) changes.stale.push_back(j);
  }
  for (Index j = 0; j < chart.size(); ++j) {
    const Index vertex = chart.vertex[j];
    const auto stale = [&](Index node) { return chart.vertex[node] == vertex; };
    const bool altered = std::ranges::any_of(changes.stale, stale) ||
                         std::ranges::count(old.vertex, vertex) != std::ranges::count(chart.vertex, vertex);
    if (altered && chart.sheet[j] == 0) changes.altered.push_back(j);
  }
  for (const Index vertex : old.vertex)
    if (!std::ranges::count(chart.vertex, vertex) && !std::ranges::count(changes.left, vertex))
      changes.left.push_back(vertex);
  return changes;
}

TEST(StrokeChanges, AgreesWithALookupNodeByNode) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::size_t seen_stale = 0, seen_left = 0, seen_kept = 0, seen_less = 0;
  for (int round = 0; round < 200; ++round) {
    Nodes before, now;
    for (Index vertex = 0; vertex < 30; ++vertex) {
      for (double t = 0; t < 5; ++t) {
        const Node node{t, 0, Vec3f::UnitX(), {}};
        if (random() % 4 == 0) before.insert({vertex, node});
        if (random() % 4 == 0) now.insert({vertex, node});
      }
    }
    const StrokeNodes nodes_before = nodes_of(before), nodes_now = nodes_of(now);
    const StrokeChanges changes = find_changes(nodes_before, nodes_now, 4, BURIN_INPUT_T);
    const StrokeChanges expected = looked_up(nodes_before, nodes_now, 4);
    ASSERT_EQ(changes.stale, expected.stale);
    ASSERT_EQ(changes.before, expected.before);
    ASSERT_EQ(changes.altered, expected.altered);
    ASSERT_EQ(changes.left, expected.left);
    seen_stale += changes.stale.size();
    seen_left += changes.left.size();
    seen_kept += now.size() - changes.stale.size();
    seen_less += before.size() > now.size() ? 1 : 0;
  }
  EXPECT_GT(seen_stale, 500u);
  EXPECT_GT(seen_left, 500u);
  EXPECT_GT(seen_kept, 500u);
  EXPECT_GT(seen_less, 50u);
}

}  // namespace
}  // namespace burin
