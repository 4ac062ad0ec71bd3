#pragma once
#include <burin/deform/batch.h>
#include <burin/deform/brush_stroke.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// Evaluates brushes over nodes in batches on all threads. Keeps its buffers from call to call.
/// One thread at a time.
class Evaluator {
 public:
  Evaluator();
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Runs all passes of the stroke over these nodes of source.nodes; [i] of the result is the displacement
  /// by nodes[i], in its (e1, e2, n). Strength, with the dynamics of the nodes, scales what the last pass
  /// wrote, so passes see each other at full strength.
  /// The result does not depend on which other nodes are computed along. Valid until the next call.
  /// Throws ContractError naming brush and (t, d) when the brush fails or a number is not finite, for the
  /// lowest such batch or node of the earliest such pass.
  std::span<const Vec3f> evaluate(const BrushStroke& stroke, const burin_stroke_context& context,
                                  const NodeSource& source, std::span<const Index> nodes, float strength);

 private:
  class BatchPool;
  std::unique_ptr<BatchPool> pool_;
  std::vector<Vec3f> displacement_;  ///< [i] of nodes[i], in (e1, e2, n)
};

}  // namespace burin
