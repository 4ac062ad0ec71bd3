#include "stock_brush.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace burin::test {

namespace {

unsigned printed(unsigned seed) {
  testing::Test::RecordProperty("seed", static_cast<int>(seed));
  std::cout << "seed " << seed << '\n';
  return seed;
}

float distance(const Displaced& moved, std::size_t i, std::size_t j) {
  return std::hypot(moved.along[i] - moved.along[j], moved.across[i] - moved.across[j],
                    moved.up[i] - moved.up[j]);
}

}  // namespace

std::vector<float> steps(int n, float last) {
  std::vector<float> values;
  for (int i = 0; i <= n; ++i) values.push_back(last * static_cast<float>(i) / static_cast<float>(n));
  return values;
}

StockBrush::StockBrush(const std::string& name)
    : seed_(printed(std::random_device{}())),
      engine_(seed_),
      module_("brushes/" + name),
      stroke_(module_, ("org.burin." + name).c_str(), host_.abi),
      descriptor_(module_.descriptor("org.burin." + name)) {}

Displaced StockBrush::evaluate(const Nodes& nodes) {
  stroke_.end();
  EXPECT_EQ(stroke_.begin().status, BURIN_OK);
  const Answer answer = stroke_.evaluate(nodes);
  EXPECT_EQ(answer.status, BURIN_OK) << answer.text;
  return {stroke_.along, stroke_.across, stroke_.up};
}

Vector StockBrush::at(float t, float d) {
  Nodes nodes{{t}, {d}, static_cast<float>(stroke_.context.radius_max)};
  add_inputs(nodes);
  const Displaced moved = evaluate(nodes);
  return {moved.along[0], moved.across[0], moved.up[0]};
}

Nodes StockBrush::random_nodes(std::size_t count) {
  const auto radius = static_cast<float>(stroke_.context.radius_max);
  const auto length = static_cast<float>(stroke_.context.length);
  Nodes nodes{{}, {}, radius};
  while (nodes.t.size() < count) {
    const float t = random(-radius, length + radius), d = random(-radius, radius);
    if (!in_chart(t, d)) continue;
    nodes.t.push_back(t);
    nodes.d.push_back(d);
  }
  add_inputs(nodes);
  return nodes;
}

bool StockBrush::in_chart(float t, float d) const {
  const double length = stroke_.context.length;
  if (stroke_.context.flags & BURIN_STROKE_CLOSED) return 0 <= t && t < length;
  const double beyond = std::max({0.0, -static_cast<double>(t), t - length});
  return std::hypot(beyond, d) <= stroke_.context.radius_max;
}

void StockBrush::expect_no_step(float steepest) {
  constexpr int ways = 60, count = 2000;
  float steepest_found = 0;
  for (int way = 0; way < ways; ++way) {
    const auto length = static_cast<float>(stroke_.context.length);
    const float t0 = random(-1.5f, length + 1.5f), t1 = t0 + random(-3, 3);
    const float d0 = random(-1.5f, 1.5f), d1 = random(-1.5f, 1.5f);
    Nodes nodes;
    for (const float s : steps(count, 1)) {
      nodes.t.push_back(t0 + s * (t1 - t0));
      nodes.d.push_back(d0 + s * (d1 - d0));
    }
    add_inputs(nodes);
    Displaced moved = evaluate(nodes);
    for (std::size_t i = 0; i <= count; ++i)
      if (!in_chart(nodes.t[i], nodes.d[i])) moved.along[i] = moved.across[i] = moved.up[i] = 0;
    const float step = std::hypot(t1 - t0, d1 - d0) / count;
    for (std::size_t i = 1; i <= count; ++i) {
      const float found = distance(moved, i, i - 1);
      ASSERT_LE(found, steepest * step + 2e-6f) << "at t " << nodes.t[i] << ", d " << nodes.d[i];
      steepest_found = std::max(steepest_found, found / step);
    }
  }
  EXPECT_GT(steepest_found, 0.1f * steepest) << "the bound is no bound";
}

void StockBrush::expect_closed_seam() {
  stroke_.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_FINAL;
  for (const double length : {10.0, 7.3, 1.9}) {
    stroke_.context.length = length;
    Nodes start, end;
    for (const float d : steps(200, 2)) {
      start.t.push_back(0);
      end.t.push_back(static_cast<float>(length));
      start.d.push_back(d - 1);
    }
    end.d = start.d;
    add_inputs(start);
    add_inputs(end);
    const Displaced first = evaluate(start), last = evaluate(end);
    float most = 0;
    for (std::size_t i = 0; i < start.t.size(); ++i) {
      EXPECT_NEAR(first.along[i], last.along[i], 2e-5);
      EXPECT_NEAR(first.across[i], last.across[i], 2e-5);
      EXPECT_NEAR(first.up[i], last.up[i], 2e-5) << "length " << length << ", d " << start.d[i];
      most = std::max(most, std::abs(first.up[i]));
    }
    EXPECT_GT(most, 0.01f) << "something is there";
  }
}

void StockBrush::set_size(double radius, double length) {
  stroke_.context.radius_min = stroke_.context.radius_max = radius;
  stroke_.context.length = length;
}

void StockBrush::expect_scale_invariance() {
  Nodes nodes = random_nodes(1000);
  const Displaced before = evaluate(nodes);
  set_size(2, 20);
  for (float& t : nodes.t) t *= 2;
  for (float& d : nodes.d) d *= 2;
  nodes.radius *= 2;
  nodes.footprint_t *= 2;
  nodes.footprint_d *= 2;
  const Displaced after = evaluate(nodes);
  for (std::size_t i = 0; i < nodes.t.size(); ++i) {
    ASSERT_NEAR(after.along[i], 2 * before.along[i], 1e-5);
    ASSERT_NEAR(after.across[i], 2 * before.across[i], 1e-5);
    ASSERT_NEAR(after.up[i], 2 * before.up[i], 1e-5);
  }
  EXPECT_GT(*std::max_element(after.up.begin(), after.up.end()), 0.01f);
}

void StockBrush::expect_same_on_both_sides() {
  Nodes nodes = random_nodes(1000);
  const Displaced left = evaluate(nodes);
  for (float& d : nodes.d) d = -d;
  const Displaced right = evaluate(nodes);
  for (std::size_t i = 0; i < nodes.t.size(); ++i) {
    ASSERT_EQ(right.along[i], left.along[i]);
    ASSERT_EQ(right.across[i], -left.across[i]);
    ASSERT_EQ(right.up[i], left.up[i]);
  }
}

void StockBrush::set_random_params() {
  for (std::uint32_t i = 0; i < descriptor_.param_count; ++i) {
    const burin_param_info& param = *descriptor_.params[i];
    if (param.type == BURIN_PARAM_FLOAT) stroke_.params.set(param.id, random(param.soft_min, param.soft_max));
    if (param.type != BURIN_PARAM_INT && param.type != BURIN_PARAM_CHOICE) continue;
    std::uniform_int_distribution<int> whole(static_cast<int>(param.soft_min),
                                             static_cast<int>(param.soft_max));
    stroke_.params.set(param.id, static_cast<float>(whole(engine_)));
  }
}

void StockBrush::expect_finite() {
  const auto finite = [](float x) { return std::isfinite(x); };
  for (const double radius : {1e-5, 1.0, 1e5}) {
    for (const double length : {0.0, 0.3, 5000.0}) {
      for (const std::uint64_t kind : {std::uint64_t{0}, BURIN_STROKE_CLOSED, BURIN_STROKE_DAB}) {
        if (length > 0 ? kind == BURIN_STROKE_DAB : kind == BURIN_STROKE_CLOSED) continue;
        SCOPED_TRACE(testing::Message() << "radius " << radius << ", " << length << " radii, kind " << kind);
        set_size(radius, length * radius);
        stroke_.context.flags = kind | BURIN_STROKE_FINAL;
        set_random_params();
        Nodes nodes = random_nodes(500);
        nodes.t[0] = nodes.d[0] = 0;
        nodes.t[1] = static_cast<float>(stroke_.context.length);
        nodes.d[1] = nodes.radius;
        for (const float share : steps(499, 1)) nodes.radii.push_back(nodes.radius * std::max(share, 0.02f));
        const Displaced moved = evaluate(nodes);
        EXPECT_TRUE(std::all_of(moved.along.begin(), moved.along.end(), finite));
        EXPECT_TRUE(std::all_of(moved.across.begin(), moved.across.end(), finite));
        EXPECT_TRUE(std::all_of(moved.up.begin(), moved.up.end(), finite));
      }
    }
  }
}

}  // namespace burin::test
