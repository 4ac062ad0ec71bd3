#pragma once
#include <burin/deform/evaluate/batch.h>
#include <burin/volume/solid.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Buffers for one call of a brush's distance, filled anew for every batch: what holds at points between the
/// nodes of a stroke, interpolated.
class SolidBatch {
 public:
  static constexpr std::size_t capacity = Batch::capacity;

  /// The inputs that solids may read.
  static constexpr std::uint64_t inputs_offered =
      BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_RADIUS | BURIN_INPUT_STRETCH | BURIN_INPUT_POSITION |
      BURIN_INPUT_NORMAL | BURIN_INPUT_E1 | BURIN_INPUT_SHEET | BURIN_INPUT_VISIT_COUNT |
      BURIN_INPUT_NODE_ID | BURIN_INPUT_SYMMETRY | BURIN_INPUT_PRESSURE | BURIN_INPUT_TILT |
      BURIN_INPUT_TWIST | BURIN_INPUT_SPEED | BURIN_INPUT_TIME;

  /// Fills the declared `inputs` of at most `capacity` points. `slots`: of the chart's nodes in the source.
  /// Node ids, sheets and counts are those of the node of the largest weight.
  void fill(const NodeSource& source, std::uint64_t inputs, const burin_params& params,
            std::span<const ShellPoint> points, std::span<const Index> slots);

  const burin_batch& inputs() const { return batch_; }
  burin_floats heights() const { return {heights_.data(), 1, 0}; }

  /// Where the brush writes distances; [point].
  burin_floats_out distances() { return {distances_.data(), 1, 0}; }
  std::span<const float> written() const { return std::span(distances_).first(batch_.count); }

 private:
  void mix(burin_floats& values, const burin_floats& a, const burin_floats& b, const burin_floats& c);
  void mix_directions(burin_vectors& values, const burin_vectors& a, const burin_vectors& b,
                      const burin_vectors& c);
  void mix_params();
  void choose(burin_indices& values, std::vector<std::uint32_t>& column, burin_indices burin_batch::*member);
  void fill_coordinates(const NodeSource& source, std::uint64_t inputs);
  float* next_column();

  std::array<Batch, 3> corners_;  ///< the batches of the points' first, second and third nodes
  std::span<const ShellPoint> points_;
  std::vector<Index> nodes_;
  std::vector<float> columns_;
  std::size_t used_columns_ = 0;
  std::vector<burin_param_value> param_values_;
  burin_params params_{};
  std::vector<std::uint32_t> sheets_, visit_counts_, node_ids_;
  std::vector<float> heights_, distances_;
  burin_batch batch_{};
};

}  // namespace burin
