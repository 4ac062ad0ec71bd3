#pragma once
#include <burin/abi/stroke.h>
#include <burin/deform/evaluate/batch_params.h>
#include <burin/deform/evaluate/current_base.h>
#include <burin/deform/evaluate/pass_positions.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/deform/paint.h>
#include <burin/stroke/curve/foot_line.h>
#include <burin/surface/base_surface/base_foot.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Everything from which the inputs of a stroke's nodes are read. Non-owning.
struct NodeSource {
  const Surface& surface;  ///< the surface before the stroke
  const StrokeNodes& nodes;
  float radius;                           ///< half width, object units, of nodes without one of their own
  const Paint* paint = nullptr;           ///< colours and masks before the stroke; null: none
  const FootLine* foot = nullptr;         ///< the stroke's foot line, if the brush reads it
  const PassPositions* before = nullptr;  ///< positions after the previous pass; null: those of the base
  const CurrentBase* current = nullptr;   ///< geometry of nodes that depend on earlier visits; null: none
  std::uint32_t symmetry = 0;             ///< index of the symmetry instance
  bool mirrored = false;                  ///< BURIN_STROKE_MIRRORED: the brush sees d and e2 negated
  std::span<const float> dab_t = {};  ///< [slot] t within the node's dab, instead of the chart's; or empty
  BaseSurface* base = nullptr;        ///< the base surface on which the stroke runs; null: the surface itself

  /// The position of a vertex's foot on the base surface.
  Vec3f base_position(Index vertex) const {
    return base ? burin::base_position(*base, surface, vertex) : surface.positions[vertex];
  }

  const Paint& painted() const {
    static const Paint bare;
    return paint ? *paint : bare;
  }
};

/// Buffers for one call of a brush, refilled for every batch. One thread at a time.
class Batch {
 public:
  static constexpr std::size_t capacity = 1024;

  Batch();

  /// Fills the declared `inputs` of at most `capacity` nodes, and the outputs with their initial values: no
  /// displacement, and the paint before the stroke. `displacement` holds, for each node, its displacement
  /// after the previous pass in (e1, e2, n), object units; it is empty in the first pass.
  void fill(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs, const burin_params& params,
            std::span<const Index> nodes, std::span<const Vec3f> displacement);

  const burin_batch& inputs() const { return batch_; }
  const burin_outputs& outputs() const { return outputs_; }

  /// The displacement that the brush wrote for element i, in (e1, e2 = n x e1, n), object units.
  Vec3f displacement(std::size_t i) const;

  /// The colour and mask that the brush wrote for element i, clamped to 0..1 if finite; those that it does
  /// not write are as before the stroke.
  Tint tint(std::size_t i) const;

 private:
  template <class Value>
  burin_floats numbers(std::span<const Index> nodes, const Value& value);
  template <class Value>
  burin_vectors vectors(std::size_t count, const Value& value);
  template <class Value>
  burin_indices numbers(std::span<const Index> nodes, std::vector<std::uint32_t>& column, const Value& value);
  void fill_outputs(std::uint64_t outputs, std::span<const Index> nodes);
  void fill_chart(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_radius(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_positions(std::uint64_t inputs, std::span<const Index> nodes,
                      std::span<const Vec3f> displacement);
  void fill_fine(std::uint64_t inputs, std::span<const Index> nodes, std::span<const Vec3f> displacement);
  void fill_surroundings(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_paint(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_end_distance(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_foot(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_pen(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_names(std::uint64_t inputs, std::span<const Index> nodes);
  float* next_column();
  /// The geometry of a node that depends on earlier visits, or null.
  const CurrentBase::Geometry* current(Index node) const {
    return source_->current ? source_->current->find(node) : nullptr;
  }
  Vec3f in_brush_frame(const Vec3f& components) const;
  Vec3f after_pass_before(const Vec3f& position, Index node, std::span<const Vec3f> displacement,
                          std::size_t i) const;
  Index vertex(Index node) const { return source_->nodes.chart().vertex[node]; }

  const NodeSource* source_ = nullptr;  ///< source of the current or last fill()
  std::vector<Tint> tints_before_;      ///< [element], if the brush writes colours or masks
  std::vector<float> columns_;          ///< columns of `capacity` floats: outputs, then inputs
  std::size_t used_columns_ = 0;
  std::vector<std::uint32_t> sheets_, visit_counts_, node_ids_;
  float radius_ = 0;
  std::uint32_t symmetry_ = 0;
  bool mirrored_ = false;
  BatchParams params_;
  burin_batch batch_{};
  burin_outputs outputs_{};
};

}  // namespace burin
