#pragma once
#include <burin/abi/brush.h>
#include <burin/deform/evaluate/supported_inputs.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace burin::validate {

/// An input of burin_batch: neighbouring members of type burin_floats or burin_indices.
struct InputColumns {
  std::uint64_t bit;  ///< BURIN_INPUT_*
  std::string_view name;
  std::size_t offset;  ///< of the first member, bytes
  std::size_t count;   ///< of members
  int length_power;    ///< how the input scales with the surface: 1 lengths, -1 curvatures, 0 plain numbers
};

/// All inputs of the ABI, in the order of burin_batch.
std::span<const InputColumns> input_columns();
inline constexpr std::size_t column_count = sum(all_inputs).bytes / sizeof(burin_floats);

/// Chart nodes of a straight stroke on a plane, [column][node]. Numbers of the columns follow
/// input_columns().
struct Nodes {
  std::vector<std::vector<float>> columns;  ///< indices as the bits of floats
  std::size_t size() const { return columns.empty() ? 0 : columns[0].size(); }
  float& t(std::size_t i) { return columns[0][i]; }
  float& d(std::size_t i) { return columns[1][i]; }
  float t(std::size_t i) const { return columns[0][i]; }
  float d(std::size_t i) const { return columns[1][i]; }
  float radius(std::size_t i) const { return columns[2][i]; }

  /// The column of an input's member.
  std::vector<float>& of(std::uint64_t bit, std::size_t member = 0);
};

/// The stroke on which nodes lie: radius 1, length 10 object units.
burin_stroke_context stroke_context();

/// The same when the stroke has ended.
burin_stroke_context finished_context();

/// That stroke as begin gets it: nothing of it is drawn yet.
burin_stroke_context empty_stroke_context();

/// `count` nodes spread over the stroke and its caps by a random generator.
Nodes random_nodes(std::size_t count, std::uint64_t seed);

/// A node for each pair of t and d.
Nodes nodes_at(std::span<const float> t, std::span<const float> d);

/// Makes numbers vary from node to node that may: radii from 1 to the largest, pressure, speed, mask, colour.
inline constexpr float largest_varied_radius = 1.5f;
void vary(Nodes& nodes);

/// The nodes of a surface that is `factor` times as large.
void scale(Nodes& nodes, float factor);

/// The nodes of a surface that is turned, or mirrored, by this matrix, by rows, and then moved.
void turn(Nodes& nodes, std::span<const float, 9> matrix, std::span<const float, 3> move);

}  // namespace burin::validate
