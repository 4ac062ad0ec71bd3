// Phases of nodes: the table in front_node.h, and that nodes of fronts keep to it.
#include <burin/chart/front/front.h>
#include <burin/chart/front/front_node.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

FrontNode node_of(NodeState state, float g, bool stale, bool gathered, bool waiting) {
  FrontNode node;
  node.key = front_key(g, 7);
  node.state = state;
  node.stale = stale;
  node.gathered = gathered;
  node.waiting = waiting;
  return node;
}

TEST(FrontNode, HasTheCombinationsOfTheTableOnly) {
  std::map<NodePhase, int> count;
  for (const NodeState state : {NodeState::open, NodeState::inside, NodeState::outside})
    for (const float g : {unreached, 2.F})
      for (int flags = 0; flags < 8; ++flags)
        ++count[node_of(state, g, flags & 1, flags & 2, flags & 4).phase()];
  EXPECT_EQ(count, (std::map<NodePhase, int>{{NodePhase::not_reached, 1},
                                             {NodePhase::queued, 1},
                                             {NodePhase::gathered, 1},
                                             {NodePhase::settled, 2},
                                             {NodePhase::stale, 2},
                                             {NodePhase::regathered, 2},
                                             {NodePhase::marked, 8},
                                             {NodePhase::taken_back, 1},
                                             {NodePhase::impossible, 30}}));
}

TEST(FrontNode, TellsPhasesByTheTable) {
  using enum NodeState;
  EXPECT_EQ(node_of(open, unreached, false, false, false).phase(), NodePhase::not_reached);
  EXPECT_EQ(node_of(open, 2, false, false, false).phase(), NodePhase::queued);
  EXPECT_EQ(node_of(open, 2, false, true, false).phase(), NodePhase::gathered);
  EXPECT_EQ(node_of(outside, 2, false, false, false).phase(), NodePhase::settled);
  EXPECT_EQ(node_of(inside, 2, true, false, false).phase(), NodePhase::stale);
  EXPECT_EQ(node_of(inside, 2, true, true, false).phase(), NodePhase::regathered);
  EXPECT_EQ(node_of(open, unreached, false, false, true).phase(), NodePhase::taken_back);
  EXPECT_EQ(node_of(inside, 2, true, true, true).phase(), NodePhase::marked);
  EXPECT_EQ(node_of(open, 2, true, false, false).phase(), NodePhase::impossible);
  EXPECT_EQ(node_of(inside, unreached, false, false, false).phase(), NodePhase::impossible);
  EXPECT_EQ(node_of(inside, 2, false, true, false).phase(), NodePhase::impossible);
}

TEST(FrontNode, GoesFromPhaseToPhase) {
  FrontNode node = node_of(NodeState::open, unreached, false, false, false);
  const auto becomes = [&node](NodePhase phase) { EXPECT_EQ(node.phase(), phase); };
  node.reach(3);
  becomes(NodePhase::queued);
  node.gather();
  becomes(NodePhase::gathered);
  node.reach(2);
  node.leave_gathered();
  becomes(NodePhase::queued);
  node.gather();
  node.settle(NodeState::outside);
  becomes(NodePhase::settled);
  node.make_stale();
  becomes(NodePhase::stale);
  node.gather();
  becomes(NodePhase::regathered);
  node.leave_gathered();
  becomes(NodePhase::stale);
  node.gather();
  node.settle_again();
  becomes(NodePhase::settled);
  EXPECT_EQ(node.state, NodeState::outside);
  EXPECT_EQ(node.g(), 2);
  node.mark();
  becomes(NodePhase::marked);
  node.make_stale();
  becomes(NodePhase::marked);
  node.leader_count = 3;
  node.depends_to = 1;
  node.take_back();
  becomes(NodePhase::taken_back);
  EXPECT_EQ(node.leader_count, 0);
  EXPECT_EQ(node.depends_to, -unreached);
  EXPECT_EQ(node.vertex(), 7u);
  node.release();
  becomes(NodePhase::not_reached);
}

/// A figure of eight on the unit sphere.
std::vector<Vec3d> crossing(std::size_t count) {
  std::vector<Vec3d> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 0.25 * static_cast<double>(i);
    samples.push_back(Vec3d(0.5 * std::sin(angle), 0.4 * std::sin(2 * angle), 1).normalized());
  }
  return samples;
}

TEST(FrontNode, IsAtRestBetweenUpdates) {
  const Surface surface = make_surface(test::sphere(4, 0.3, 3));
  const Picker picker(surface);
  const ChartGround ground(surface);
  for (const std::size_t parts : {1u, 3u}) {
    Front front(ground);
    constexpr double radius = 0.25;
    front.restart(radius, 2);
    std::map<NodePhase, std::size_t> count;
    // Shorter strokes take nodes back.
    for (const std::size_t length : {2u, 9u, 12u, 8u, 20u, 24u, 5u, 24u}) {
      front.update(test::traced(surface, picker, radius, crossing(length)), 0, parts);
      front.for_each_touched([&](Index, const FrontNode& node) { ++count[node.phase()]; });
    }
    EXPECT_GT(count[NodePhase::settled], 1000u) << parts;
    EXPECT_GT(count[NodePhase::not_reached], 200u) << parts;
    EXPECT_EQ(count.size(), 2u) << parts;
  }
}

}  // namespace
}  // namespace burin
