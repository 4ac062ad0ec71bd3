#pragma once
#include <burin/abi/stroke.h>
#include <burin/deform/evaluate/batch_params.h>
#include <burin/deform/evaluate/current_base.h>
#include <burin/deform/evaluate/pass_places.h>
#include <burin/deform/evaluate/stroke_nodes.h>
#include <burin/deform/paint.h>
#include <burin/stroke/curve/foot_line.h>
#include <burin/surface/base_surface/base_place.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// What the nodes of a stroke stand on. Looked at, not owned.
struct NodeSource {
  const Surface& surface;  ///< as it was when the stroke began
  const StrokeNodes& nodes;
  float radius;                          ///< object units, where nodes have no half width of their own
  const Paint* paint = nullptr;          ///< of the surface; null: none
  const FootLine* foot = nullptr;        ///< of the stroke, where the brush reads it
  const PassPlaces* places = nullptr;    ///< where vertices stand after the pass before; null: at their base
  const CurrentBase* current = nullptr;  ///< of nodes that stand on what the stroke made before; null: none
  std::uint32_t symmetry = 0;            ///< instance
  bool mirrored = false;              ///< BURIN_STROKE_MIRRORED: the brush sees d and e2 the other way round
  std::span<const float> dab_t = {};  ///< [slot] t within the node's dab, instead of the chart's; or empty
  BaseSurface* base = nullptr;        ///< that the stroke runs on; null: the surface itself

  /// Where a vertex stands on the base surface.
  Vec3f base_place(Index vertex) const {
    return base ? base_position(*base, surface, vertex) : surface.positions[vertex];
  }

  const Paint& painted() const {
    static const Paint bare;
    return paint ? *paint : bare;
  }
};

/// Buffers for one call of a brush, filled anew for every batch.
class Batch {
 public:
  static constexpr std::size_t capacity = 1024;

  Batch();

  /// Fills the declared `inputs` of at most `capacity` nodes, and the outputs with what they hold before.
  /// `displacement`: [i] of nodes[i] after the pass before, in (e1, e2, n); empty in the first pass.
  void fill(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs, const burin_params& params,
            std::span<const Index> nodes, std::span<const Vec3f> displacement);

  const burin_batch& inputs() const { return batch_; }
  const burin_outputs& outputs() const { return outputs_; }

  /// What the brush wrote for element i, in (e1, e2 = n x e1, n).
  Vec3f displacement(std::size_t i) const;

  /// Colour and mask that it wrote, brought within 0..1 where finite, or those before.
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
  void fill_place(std::uint64_t inputs, std::span<const Index> nodes, std::span<const Vec3f> displacement);
  void fill_fine(std::uint64_t inputs, std::span<const Index> nodes, std::span<const Vec3f> displacement);
  void fill_surroundings(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_paint(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_foot(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_pen(std::uint64_t inputs, std::span<const Index> nodes);
  void fill_names(std::uint64_t inputs, std::span<const Index> nodes);
  float* next_column();
  /// Of a node that does not stand on the base surface, or null.
  const CurrentBase::Place* current(Index node) const {
    return source_->current ? source_->current->find(node) : nullptr;
  }
  Vec3f in_brush_frame(const Vec3f& components) const;
  Vec3f after_pass_before(const Vec3f& place, Index node, std::span<const Vec3f> displacement,
                          std::size_t i) const;
  Index vertex(Index node) const { return source_->nodes.chart().vertex[node]; }

  const NodeSource* source_ = nullptr;  ///< of the fill that is going on, or the last
  std::vector<Tint> tints_before_;      ///< [element] where the brush writes colours or masks
  std::vector<float> columns_;          ///< column after column, `capacity` each: the outputs', then inputs
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
