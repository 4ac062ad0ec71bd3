#include <algorithm>
#include <cmath>
#include <numeric>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Displaced;
using test::Nodes;

enum Pattern { bark, noise };

class Bark : public test::StockBrush {
 protected:
  Bark() : StockBrush("bark") {}

  static float mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0f) / static_cast<float>(values.size());
  }
  static float amplitude(const std::vector<float>& values) {
    float squares = 0;
    for (const float value : values) squares += value * value;
    return std::sqrt(squares / static_cast<float>(values.size()));
  }
};

TEST_F(Bark, StaysWithinItsDepth) {
  stroke_.params.set("depth", 0.5f);
  stroke_.context.length = 500;
  for (const float pattern : {bark, noise}) {
    stroke_.params.set("pattern", pattern);
    const auto up = evaluate(random_nodes(20000)).up;
    EXPECT_LE(*std::max_element(up.begin(), up.end()), 0.5f);
    EXPECT_GE(*std::min_element(up.begin(), up.end()), -0.5f);
    EXPECT_GT(amplitude(up), 0.04f);
    EXPECT_NEAR(mean(up), 0, 0.02f);
  }
}

TEST_F(Bark, LeavesOutWhatTheMeshCannotShow) {
  stroke_.params.set("grain", 0.5f);
  stroke_.params.set("stretch", 2);
  Nodes nodes = random_nodes(5000);
  std::vector<float> amplitudes;
  for (const float footprint : {0.001f, 0.05f, 0.1f, 0.2f, 0.26f}) {
    nodes.footprint_d = footprint;
    nodes.footprint_t = footprint / 2;
    amplitudes.push_back(amplitude(evaluate(nodes).up));
  }
  EXPECT_TRUE(std::is_sorted(amplitudes.rbegin(), amplitudes.rend()));
  EXPECT_GT(amplitudes[3], 0.01f);
  EXPECT_EQ(amplitudes.back(), 0) << "cells of half a radius need nodes of a quarter";
  nodes.footprint_d = 0.001f;
  nodes.footprint_t = 0.51f;
  EXPECT_EQ(amplitude(evaluate(nodes).up), 0);
}

TEST_F(Bark, DiffersFromStrokeToStroke) {
  stroke_.context.length = 500;  // of some thousand cells
  const Nodes nodes = random_nodes(5000);
  const auto first = evaluate(nodes).up;
  EXPECT_EQ(evaluate(nodes).up, first);
  stroke_.context.seed = 1;
  const auto second = evaluate(nodes).up;
  float product = 0;
  for (std::size_t i = 0; i < first.size(); ++i) product += first[i] * second[i];
  EXPECT_LT(std::abs(product) / static_cast<float>(first.size()),
            0.3f * amplitude(first) * amplitude(second));
}

TEST_F(Bark, IsDrawnOutAlongTheStroke) {
  stroke_.params.set("stretch", 5);
  stroke_.params.set("pattern", noise);
  stroke_.context.length = 500;
  Nodes nodes = random_nodes(20000);
  for (float& d : nodes.d) d *= 0.5f;
  const auto up = evaluate(nodes).up;
  Nodes ahead = nodes, beside = nodes;
  for (float& t : ahead.t) t += 0.01f;
  for (float& d : beside.d) d += 0.01f;
  const auto there = evaluate(ahead).up, side = evaluate(beside).up;
  float along = 0, across = 0;
  for (std::size_t i = 0; i < up.size(); ++i) {
    along += (there[i] - up[i]) * (there[i] - up[i]);
    across += (side[i] - up[i]) * (side[i] - up[i]);
  }
  EXPECT_NEAR(std::sqrt(across / along), 5, 1);
}

TEST_F(Bark, HasNoStep) {
  stroke_.params.set("pattern", noise);
  expect_no_step(4);
}
TEST_F(Bark, HasNoSeam) {
  for (const float pattern : {bark, noise}) {
    stroke_.params.set("pattern", pattern);
    stroke_.params.set("roughness", 0.2f);
    expect_closed_seam();
  }
}
TEST_F(Bark, GrowsWithTheStroke) {
  stroke_.params.set("pattern", noise);
  expect_scale_invariance();
}
TEST_F(Bark, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
