// Chooses between nodes that two legs have at one vertex, around a corner at t = 10 that turns left.
#include <burin/chart/joins/leg_choice.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

constexpr double choice_radius = 1;

std::vector<LegEnds> two_legs(bool continued) {
  const Corner corner{.first = 10, .second = 10, .first_past = 0, .second_past = 0, .turn = 1.5, .span = 4};
  return {{std::nullopt, LegEnd{corner, 0, true, 1, continued}},
          {LegEnd{corner, 0, false, 0, continued}, std::nullopt}};
}

LegNode node(Index leg, double t, float d, double distance) {
  return {.part = part_of_leg(leg), .slot = 0, .frame = {.t = t, .d = d}, .ray = {}, .distance = distance};
}

std::vector<double> kept(std::vector<LegNode> nodes, bool continued = true) {
  choose_at_corners(nodes, two_legs(continued), choice_radius);
  std::erase_if(nodes, [](const LegNode& each) { return each.dropped; });
  std::vector<double> t;
  for (const LegNode& each : nodes) t.push_back(each.frame.t);
  return t;
}

TEST(LegChoice, TakesTheLegThatReachesLessFarBeyondTheCorner) {
  EXPECT_EQ(kept({node(0, 10.1, -0.5F, 0.5), node(1, 9.7, -0.4F, 0.5)}), std::vector{10.1});
  EXPECT_EQ(kept({node(0, 10.3, -0.5F, 0.5), node(1, 9.9, -0.4F, 0.5)}), std::vector{9.9});
}

// A node that lies before the begin of a short leg is farther from the corner and from the stroke.
TEST(LegChoice, TakesTheNearerLegBesideBoth) {
  EXPECT_EQ(kept({node(0, 8.9, 0.9F, 1.1), node(1, 11, 0.5F, 0.5)}), std::vector{11.});
  EXPECT_EQ(kept({node(0, 8.9, 0.4F, 0.4), node(1, 10.9, 0.5F, 0.5)}), std::vector{8.9});
}

TEST(LegChoice, KeepsBothWhereLegsAreNotContinued) {
  EXPECT_EQ(kept({node(0, 9, 0.1F, 0.1), node(1, 11, -0.1F, 0.1)}, false), (std::vector{9., 11.}));
  EXPECT_EQ(kept({node(0, 10.1, 0.5F, 0.5), node(1, 10.3, 0.5F, 0.5)}, false), std::vector{10.3});
}

TEST(LegChoice, KeepsNodesFarFromTheCorner) {
  EXPECT_EQ(kept({node(0, 5, 0.5F, 0.5), node(1, 11, 0.1F, 0.1)}), (std::vector{5., 11.}));
}

TEST(LegChoice, DropsNodesBeyondTheBisectorOfALegAlone) {
  EXPECT_EQ(kept({node(0, 10.2, -0.1F, 0.2)}), std::vector<double>{});
  EXPECT_EQ(kept({node(0, 10.2, -0.5F, 0.5)}), std::vector{10.2});
}

}  // namespace
}  // namespace burin
