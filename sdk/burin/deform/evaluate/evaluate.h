#pragma once
#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/object_pool.h>

#include <span>
#include <vector>

namespace burin {

/// The greatest displacement of a brush, in radii of the stroke; a greater one is an error of the brush.
inline constexpr float farthest_displacement = 1000;

/// The outputs of a brush for a list of nodes, in the order of the list.
struct NodeOutputs {
  std::vector<Vec3f> displacement;  ///< in the node's (e1, e2, n), object units
  std::vector<Tint> tint;           ///< empty if the brush writes neither colours nor masks

  void resize(std::size_t nodes, bool paints) {
    displacement.resize(nodes);
    tint.resize(paints ? nodes : 0);
  }

  /// Copies the outputs of one node from other outputs of the same brush.
  void take(std::size_t node, const NodeOutputs& from, std::size_t node_of_from) {
    displacement[node] = from.displacement[node_of_from];
    if (!from.tint.empty()) tint[node] = from.tint[node_of_from];
  }
};

/// Whether the brush writes colours or masks.
bool paints(const burin_brush_descriptor& brush);

/// Evaluates brushes over nodes in batches on all threads. Keeps its buffers from call to call. One thread at
/// a time. Functions throw ContractError, which gives the brush and (t, d), if the brush fails, if a number
/// is not finite, or if a displacement exceeds farthest_displacement; of several failures the one of the
/// earliest pass and lowest node is reported. The result for a node does not depend on the other nodes in the
/// call.
class Evaluator {
 public:
  /// Runs all passes of the stroke over these nodes of source.nodes and applies scale() to the result. Only
  /// for brushes whose passes do not read neighbours. The result is valid until the next call.
  const NodeOutputs& evaluate(const BrushStroke& stroke, const burin_stroke_context& context,
                              const NodeSource& source, std::span<const Index> nodes, float strength);

  /// Runs the pass number context.pass. `outputs`, which has the size of `nodes`, holds the displacement
  /// after the previous pass and receives that after this pass, at full strength.
  void pass(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
            std::span<const Index> nodes, NodeOutputs& outputs);

  /// Applies strength and mask to the outputs of the last pass: displacements are multiplied by the strength,
  /// its dynamics and the mask; tints are interpolated between those before the stroke and the written ones.
  static void scale(const BrushStroke& stroke, const NodeSource& source, std::span<const Index> nodes,
                    float strength, NodeOutputs& outputs);

 private:
  void run(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
           std::span<const Index> nodes, NodeOutputs& outputs);
  void run_dab(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
               std::span<const Index> nodes, std::span<const std::size_t> chosen, NodeOutputs& outputs);

  ObjectPool<Batch> pool_;
  NodeOutputs outputs_;
};

}  // namespace burin
