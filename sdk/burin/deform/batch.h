#pragma once
#include <burin/abi/stroke.h>
#include <burin/deform/batch_params.h>
#include <burin/deform/stroke_nodes.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// What the nodes of a stroke stand on. Looked at, not owned.
struct NodeSource {
  const Surface& surface;  ///< as it was when the stroke began
  const StrokeNodes& nodes;
  float radius;  ///< object units, where nodes have no half width of their own
};

/// Buffers for one call of a brush, filled anew for every batch.
class Batch {
 public:
  static constexpr std::size_t capacity = 1024;

  Batch();

  /// Fills the declared `inputs` of at most `capacity` nodes and zeroes the outputs. `displacement`: [i] of
  /// nodes[i] after the pass before, in (e1, e2, n); empty in the first pass.
  void fill(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs, const burin_params& params,
            std::span<const Index> nodes, std::span<const Vec3f> displacement);

  const burin_batch& inputs() const { return batch_; }
  const burin_outputs& outputs() const { return outputs_; }

  /// What the brush wrote for element i.
  Vec3f displacement(std::size_t i) const;

 private:
  template <class Value>
  burin_floats numbers(std::span<const Index> nodes, const Value& value);
  template <class Value>
  burin_vectors vectors(std::size_t count, const Value& value);
  void fill_chart(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes);
  void fill_place(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes,
                  std::span<const Vec3f> displacement);
  void fill_pen(const std::vector<NodePen>& pen, std::uint64_t inputs, std::span<const Index> nodes);
  void fill_names(const NodeSource& source, std::uint64_t inputs, std::span<const Index> nodes);
  template <class Value>
  burin_indices numbers(std::span<const Index> nodes, std::vector<std::uint32_t>& column, const Value& value);
  float* next_column();

  std::vector<float> columns_;  ///< column after column, `capacity` each: the outputs' three, then inputs
  std::size_t used_columns_ = 0;
  std::vector<std::uint32_t> sheets_, visit_counts_, node_ids_;
  float radius_ = 0;
  BatchParams params_;
  burin_batch batch_{};
  burin_outputs outputs_{};
};

}  // namespace burin
