// Makes the batches of checks: nodes of a straight stroke on a plane, with a column for each input of the
// ABI.
#include "validate/probe/nodes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>

namespace burin::validate {
namespace {

constexpr std::uint64_t lengths = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_FOOTPRINT |
                                  BURIN_INPUT_POSITION | BURIN_INPUT_LAPLACIAN | BURIN_INPUT_DISPLACEMENT |
                                  BURIN_INPUT_SPEED | BURIN_INPUT_FINE_POSITION | BURIN_INPUT_END_DISTANCE,
                        curvatures = BURIN_INPUT_MEAN_CURVATURE | BURIN_INPUT_FINE_MEAN_CURVATURE;

/// The host's table has the inputs in the order of burin_batch, without a gap.
constexpr auto table = [] {
  static_assert(sizeof(burin_floats) == sizeof(burin_indices));
  std::array<InputColumns, all_inputs.size()> columns{};
  std::size_t offset = offsetof(burin_batch, t);
  for (std::size_t i = 0; i < all_inputs.size(); ++i) {
    const std::uint64_t bit = all_inputs[i].bit;
    columns[i] = {bit, all_inputs[i].name, offset, all_inputs[i].bytes / sizeof(burin_floats),
                  bit & lengths      ? 1
                  : bit & curvatures ? -1
                                     : 0};
    offset += all_inputs[i].bytes;
  }
  return columns;
}();

std::size_t first_column(std::uint64_t bit) {
  std::size_t column = 0;
  for (const InputColumns& input : table) {
    if (input.bit == bit) break;
    column += input.count;
  }
  return column;
}

void fill(Nodes& nodes, std::size_t i) {
  const float t = nodes.t(i), d = nodes.d(i);
  const auto set = [&](std::uint64_t bit, std::size_t member, float value) {
    nodes.of(bit, member)[i] = value;
  };
  set(BURIN_INPUT_RADIUS, 0, 1);
  set(BURIN_INPUT_STRETCH, 0, 1);
  set(BURIN_INPUT_FOOTPRINT, 0, 0.05f);
  set(BURIN_INPUT_FOOTPRINT, 1, 0.05f);
  for (const std::uint64_t bit : {BURIN_INPUT_POSITION, BURIN_INPUT_FINE_POSITION}) {
    set(bit, 0, t);
    set(bit, 1, d);
  }
  set(BURIN_INPUT_FINE_POSITION, 2, 0.02f * std::sin(7 * t) * std::cos(9 * d));
  set(BURIN_INPUT_NORMAL, 2, 1);
  set(BURIN_INPUT_FINE_NORMAL, 2, 1);
  set(BURIN_INPUT_E1, 0, 1);
  set(BURIN_INPUT_LAPLACIAN, 2, 0.01f * std::sin(5 * t + 3 * d));
  set(BURIN_INPUT_MASK, 0, 1);
  for (std::size_t c = 0; c < 4; ++c) set(BURIN_INPUT_COLOUR, c, 0.5f);
  set(BURIN_INPUT_VISIT_COUNT, 0, std::bit_cast<float>(std::uint32_t{1}));
  set(BURIN_INPUT_NODE_ID, 0, std::bit_cast<float>(static_cast<std::uint32_t>(i)));
  set(BURIN_INPUT_PRESSURE, 0, 0.8f);
  set(BURIN_INPUT_SPEED, 0, 2);
  set(BURIN_INPUT_TIME, 0, std::max(t, 0.0f) / 2);
  set(BURIN_INPUT_END_DISTANCE, 0, std::clamp(std::min(t, 10 - t), 0.0f, 3.0f));
  set(BURIN_INPUT_FOOT, 0, std::clamp(t, 0.0f, 10.0f));
  set(BURIN_INPUT_FOOT, 5, 1);
}

void turn_vectors(Nodes& nodes, std::size_t column, std::span<const float, 9> m,
                  std::span<const float, 3> move) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<float, 3> turned{};
    for (std::size_t row = 0; row < 3; ++row)
      turned[row] = m[3 * row] * nodes.columns[column][i] + m[3 * row + 1] * nodes.columns[column + 1][i] +
                    m[3 * row + 2] * nodes.columns[column + 2][i] + move[row];
    for (std::size_t row = 0; row < 3; ++row) nodes.columns[column + row][i] = turned[row];
  }
}

}  // namespace

std::span<const InputColumns> input_columns() { return table; }

std::vector<float>& Nodes::of(std::uint64_t bit, std::size_t member) {
  return columns[first_column(bit) + member];
}

burin_stroke_context stroke_context() {
  burin_stroke_context context{};
  context.struct_size = sizeof context;
  context.pen_present =
      BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT | BURIN_INPUT_TWIST | BURIN_INPUT_SPEED | BURIN_INPUT_TIME;
  context.seed = 42;
  context.length = 10;
  context.radius_min = context.radius_max = 1;
  context.object_scale = 30;
  return context;
}

burin_stroke_context finished_context() {
  burin_stroke_context context = stroke_context();
  context.flags = BURIN_STROKE_FINAL;
  return context;
}

burin_stroke_context empty_stroke_context() {
  burin_stroke_context context = stroke_context();
  context.length = 0;
  return context;
}

Nodes nodes_at(std::span<const float> t, std::span<const float> d) {
  Nodes nodes{std::vector(column_count, std::vector<float>(t.size()))};
  for (std::size_t i = 0; i < t.size(); ++i) {
    nodes.t(i) = t[i];
    nodes.d(i) = d[i];
    fill(nodes, i);
  }
  return nodes;
}

Nodes random_nodes(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<float>(random() >> 40) * 0x1p-24f; };
  std::vector<float> t, d;
  while (t.size() < count) {
    const float along = -1 + 12 * uniform(), across = -1 + 2 * uniform();
    const float beyond = std::max({-along, along - 10, 0.0f});
    if (std::hypot(beyond, across) > 1) continue;
    t.push_back(along);
    d.push_back(across);
  }
  return nodes_at(t, d);
}

void vary(Nodes& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    // Neighbours in the batch lie anywhere along the stroke, so each number differs from node to node.
    const float wave = 0.5f + 0.5f * std::sin(2 * nodes.t(i));
    nodes.of(BURIN_INPUT_RADIUS)[i] = 1 + (largest_varied_radius - 1) * wave;
    nodes.of(BURIN_INPUT_PRESSURE)[i] = 0.2f + 0.7f * wave;
    nodes.of(BURIN_INPUT_SPEED)[i] = 1 + 3 * wave;
    nodes.of(BURIN_INPUT_MASK)[i] = 0.5f + 0.5f * wave;
    for (std::size_t c = 0; c < 4; ++c) nodes.of(BURIN_INPUT_COLOUR, c)[i] = 0.1f + 0.8f * wave;
  }
}

void scale(Nodes& nodes, float factor) {
  std::size_t column = 0;
  for (const InputColumns& input : table) {
    for (std::size_t member = 0; member < input.count; ++member, ++column) {
      const bool foot = input.bit == BURIN_INPUT_FOOT && member < 3;
      const int power = foot ? 1 : input.length_power;
      const float by = power > 0 ? factor : power < 0 ? 1 / factor : 1;
      if (power != 0)
        for (float& number : nodes.columns[column]) number *= by;
    }
  }
}

void turn(Nodes& nodes, std::span<const float, 9> matrix, std::span<const float, 3> move) {
  constexpr std::array<float, 3> none{};
  for (const std::uint64_t bit : {BURIN_INPUT_POSITION, BURIN_INPUT_FINE_POSITION, BURIN_INPUT_FOOT})
    turn_vectors(nodes, first_column(bit), matrix, move);
  for (const std::uint64_t bit :
       {BURIN_INPUT_NORMAL, BURIN_INPUT_FINE_NORMAL, BURIN_INPUT_E1, BURIN_INPUT_LAPLACIAN})
    turn_vectors(nodes, first_column(bit), matrix, none);
  turn_vectors(nodes, first_column(BURIN_INPUT_FOOT) + 3, matrix, none);
}

}  // namespace burin::validate
