#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "plugin/driver.h"

namespace burin {
namespace {

using test::Nodes;

/// A brush of tiles or figures with its parameters at random within their sliders.
class DrawnBrush : public testing::TestWithParam<const char*> {
 protected:
  DrawnBrush() {
    std::cout << "seed " << seed_ << '\n';
    host_.pictures["map"] = {32, 16, 3, [](std::uint32_t channel, double u, double v) {
                               return static_cast<float>(std::sin(7 * u + 3 * v + channel));
                             }};
  }

  static std::string id() {
    std::string name = GetParam();
    for (char& c : name)
      if (c == '_') c = '-';
    return "org.burin." + name;
  }

  float random(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  bool toss() { return random(0, 1) < 0.5f; }

  void choose_params() {
    const burin_brush_descriptor& brush = module_.descriptor(id());
    for (std::uint32_t i = 0; i < brush.param_count; ++i) {
      const burin_param_info& param = *brush.params[i];
      const float last = param.type == BURIN_PARAM_FLOAT ? 0 : 0.999f;
      if (param.type == BURIN_PARAM_FLOAT)
        stroke_.params.set(param.id, random(param.soft_min, param.soft_max));
      if (param.type == BURIN_PARAM_CHOICE || param.type == BURIN_PARAM_BOOL)
        stroke_.params.set(param.id, std::floor(random(param.soft_min, param.soft_max + last)));
      if (param.type == BURIN_PARAM_FILE)
        stroke_.params.set_file(param.id, param.default_file && toss() ? "" : "map");
    }
  }

  Nodes random_nodes(std::size_t count) {
    const auto length = static_cast<float>(stroke_.context.length);
    Nodes nodes;
    nodes.radius = static_cast<float>(stroke_.context.radius_max);
    nodes.footprint_t = nodes.radius * random(0, 0.3f);
    nodes.footprint_d = nodes.radius * random(0, 0.3f);
    for (std::size_t i = 0; i < count; ++i) {
      nodes.t.push_back(random(-nodes.radius, length + nodes.radius));
      nodes.d.push_back(random(-nodes.radius, nodes.radius));
    }
    return nodes;
  }

  /// All outputs, one after the other.
  std::vector<float> evaluate(const Nodes& nodes) {
    const test::Answer answer = stroke_.evaluate(nodes);
    EXPECT_EQ(answer.status, BURIN_OK) << answer.text;
    std::vector<float> all;
    for (const auto* column : {&stroke_.along, &stroke_.across, &stroke_.up, &stroke_.mask,
                               &stroke_.colour[0], &stroke_.colour[3]})
      all.insert(all.end(), column->begin(), column->end());
    return all;
  }

  const unsigned seed_ = std::random_device{}();
  std::mt19937 engine_{seed_};
  test::PluginModule module_{std::string("brushes/") + GetParam()};
  test::TestHost host_;
  test::StrokeDriver stroke_{module_, id().c_str(), host_.abi};
};

INSTANTIATE_TEST_SUITE_P(All, DrawnBrush,
                         testing::Values("arrow", "dashed_line", "patterned_fill", "patterned_line", "scales",
                                         "text", "tread", "vdm_trail"),
                         [](const auto& test) { return test.param; });

TEST_P(DrawnBrush, IsFiniteOnAnyStroke) {
  const std::uint64_t kinds[] = {0, BURIN_STROKE_FINAL, BURIN_STROKE_FINAL | BURIN_STROKE_CLOSED,
                                 BURIN_STROKE_DAB, BURIN_STROKE_FINAL | BURIN_STROKE_MIRRORED};
  std::size_t moved = 0;
  for (int i = 0; i < 200; ++i) {
    choose_params();
    burin_stroke_context& context = stroke_.context;
    context.flags = kinds[i % 5];
    context.radius_max = std::pow(10, random(-3, 3));
    context.radius_min = context.radius_max / 2;
    const double length = std::pow(10, random(-2, 4)) * context.radius_max;
    context.length = context.flags & BURIN_STROKE_DAB || i % 7 == 0 ? 0 : length;
    context.dab_t = context.flags & BURIN_STROKE_DAB ? length : 0;
    context.seed = engine_();
    ASSERT_EQ(stroke_.begin().status, BURIN_OK);
    for (const float value : evaluate(random_nodes(200))) ASSERT_TRUE(std::isfinite(value)) << i;
    for (const float up : stroke_.up) moved += up != 0;
    stroke_.end();
  }
  EXPECT_GT(moved, 500u) << "it did something";
}

TEST_P(DrawnBrush, KeepsWhatLiesFartherBackThanItsEndInfluence) {
  std::size_t kept = 0;
  for (int i = 0; i < 200; ++i) {
    choose_params();
    stroke_.context.length = random(0, 30);
    ASSERT_EQ(stroke_.begin().status, BURIN_OK);
    const Nodes nodes = random_nodes(200);
    const std::vector<float> before = evaluate(nodes);
    const double unchanged = stroke_.context.length - stroke_.plan.end_influence;
    stroke_.context.length += random(0, 5);
    const std::vector<float> after = evaluate(nodes);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const float t = nodes.t[k % nodes.t.size()];
      if (t > unchanged) continue;
      ASSERT_EQ(before[k], after[k]) << t << ' ' << nodes.d[k % nodes.t.size()] << ' ' << i;
      ++kept;
    }
    stroke_.end();
  }
  EXPECT_GT(kept, 1000u);
}

}  // namespace
}  // namespace burin
