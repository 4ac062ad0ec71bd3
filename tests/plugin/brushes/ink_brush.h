#pragma once
#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <vector>

#include "plugin/driver.h"

namespace burin::test {

/// A brush that draws by Ink, its mask at 1 so that the mask it writes tells what it covers, on a stroke of
/// radius 1 and length 10.
class InkBrush : public testing::Test {
 protected:
  InkBrush(const char* module, const char* id) : module_(module), stroke_(module_, id, host_.abi) {
    stroke_.params.set("mask", 1);
    stroke_.context.flags = BURIN_STROKE_FINAL;
  }

  /// Share of each node's cell that is covered; without a size of the cells outlines are sharp.
  std::vector<float> covered(Nodes nodes, float footprint = 0) {
    nodes.footprint_t = nodes.footprint_d = footprint;
    stroke_.end();
    const Answer began = stroke_.begin(), evaluated = stroke_.evaluate(nodes);
    EXPECT_EQ(began.status, BURIN_OK) << began.text;
    EXPECT_EQ(evaluated.status, BURIN_OK) << evaluated.text;
    std::vector<float> shares;
    for (const float mask : stroke_.mask) shares.push_back(1 - mask);
    return shares;
  }
  float covered(float t, float d) { return covered(Nodes{{t}, {d}})[0]; }

  /// Mean of the coverage over t_min <= t <= t_max, |d| <= 1, sampled at cells of this size.
  double mean_covered(float t_min, float t_max, float cell) {
    Nodes nodes;
    for (float t = t_min + cell / 2; t < t_max; t += cell)
      for (float d = -1 + cell / 2; d < 1; d += cell) {
        nodes.t.push_back(t);
        nodes.d.push_back(d);
      }
    double sum = 0;
    for (const float share : covered(nodes, cell)) sum += share;
    return sum / static_cast<double>(nodes.t.size());
  }

  /// Checks hard edges against the figure's definition at random places.
  template <class Inside>
  void expect_inside(const Inside& inside) {
    const Nodes nodes = random_nodes(12000);
    const std::vector<float> shares = covered(nodes);
    std::size_t within = 0, misplaced = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const bool expected = inside(nodes.t[i], nodes.d[i]);
      within += expected;
      // Rounding may put a place on the other side of an outline.
      if (shares[i] != (expected ? 1.0f : 0.0f)) ++misplaced;
    }
    EXPECT_LE(misplaced, 10u);
    EXPECT_GT(within, 100u) << "the sample has both";
    EXPECT_LT(within, 11900u);
  }

  static Nodes random_nodes(std::size_t count) {
    const unsigned seed = std::random_device{}();
    std::cout << "seed " << seed << '\n';
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> along(-0.99f, 10.99f), across(-1, 1);
    Nodes nodes;
    for (std::size_t i = 0; i < count; ++i) {
      nodes.t.push_back(along(engine));
      nodes.d.push_back(across(engine));
    }
    return nodes;
  }

  PluginModule module_;
  TestHost host_;
  StrokeDriver stroke_;
};

}  // namespace burin::test
