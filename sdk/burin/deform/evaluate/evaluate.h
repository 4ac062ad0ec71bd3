#pragma once
#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/brush_stroke.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A brush that displaces farther than this, in radii of the stroke, has failed.
inline constexpr float farthest_displacement = 1000;

/// What a brush does at nodes, [i] for nodes[i].
struct NodeOutputs {
  std::vector<Vec3f> displacement;  ///< in the node's (e1, e2, n), object units
  std::vector<Tint> tint;           ///< empty where the brush writes neither colours nor masks

  void resize(std::size_t nodes, bool paints) {
    displacement.resize(nodes);
    tint.resize(paints ? nodes : 0);
  }

  /// Takes over what another, of the same brush, has for one node.
  void take(std::size_t node, const NodeOutputs& from, std::size_t node_of_from) {
    displacement[node] = from.displacement[node_of_from];
    if (!from.tint.empty()) tint[node] = from.tint[node_of_from];
  }
};

/// Whether the brush writes colours or masks.
bool paints(const burin_brush_descriptor& brush);

/// Evaluates brushes over nodes in batches on all threads. Keeps its buffers from call to call.
/// One thread at a time. Functions throw ContractError naming brush and (t, d) when the brush fails, a
/// number is not finite or a displacement absurdly far, for the lowest such batch or node of the earliest
/// such pass. What they give for a node does not depend on which others are computed along.
class Evaluator {
 public:
  Evaluator();
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Runs all passes of the stroke over these nodes of source.nodes, for brushes whose passes do not look at
  /// neighbours, and scales what the last one wrote. Valid until the next call.
  const NodeOutputs& evaluate(const BrushStroke& stroke, const burin_stroke_context& context,
                              const NodeSource& source, std::span<const Index> nodes, float strength);

  /// Runs the pass that the context names. `outputs`, of the size of `nodes`: the displacement after the pass
  /// before, and then that after this one, at full strength.
  void pass(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
            std::span<const Index> nodes, NodeOutputs& outputs);

  /// Makes of the last pass's outputs what is to be seen: displacement by strength, with the dynamics of the
  /// nodes, and mask, tints between those before and those written.
  static void scale(const BrushStroke& stroke, const NodeSource& source, std::span<const Index> nodes,
                    float strength, NodeOutputs& outputs);

 private:
  void run(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
           std::span<const Index> nodes, NodeOutputs& outputs);
  void run_dab(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
               std::span<const Index> nodes, std::span<const std::size_t> chosen, NodeOutputs& outputs);

  class BatchPool;
  std::unique_ptr<BatchPool> pool_;
  NodeOutputs outputs_;
};

}  // namespace burin
