#pragma once
#include <burin/deform/blend/blend.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/evaluate/pass_positions.h>

#include <span>
#include <vector>

namespace burin {

/// The arguments and outputs for evaluating one symmetry instance of a stroke.
struct EvaluatedInstance {
  NodeSource source;
  burin_stroke_context context{};
  float strength = 1;
  NodeOutputs& outputs;  ///< [slot] of the instance's chart
};

/// Runs the passes of a brush that reads neighbours. The results of each pass are kept for every node and
/// vertex, so that an event recomputes only what its changes influence; each pass extends that by one ring of
/// neighbours.
class StrokePasses {
 public:
  /// All arguments must outlive the object; `charts` are those of the stroke's instances.
  StrokePasses(const Surface& surface, const BrushStroke& stroke, std::vector<const LiveChart*> charts,
               const BlendOptions& blend);

  /// Applies changes at these vertices, which must include all that have or had stale nodes: sets the outputs
  /// of all nodes that they influence. Returns the vertices of these nodes, ascending. Throws as Evaluator.
  std::vector<Index> update(Evaluator& evaluator, std::span<EvaluatedInstance> instances,
                            std::vector<Index> vertices);

 private:
  /// The result of a pass.
  struct PassResult {
    std::vector<NodeOutputs> outputs;  ///< [instance] [slot]
    PassPositions positions;
  };
  void add_neighbours(std::vector<Index>& vertices) const;
  void run(std::uint32_t pass, Evaluator& evaluator, std::span<EvaluatedInstance> instances,
           std::span<const Index> vertices);
  void blend_vertices(std::uint32_t pass, std::span<const EvaluatedInstance> instances,
                      std::span<const Index> vertices);

  const Surface* surface_;
  const BrushStroke* stroke_;
  std::vector<const LiveChart*> charts_;
  BlendOptions blend_;
  std::vector<PassResult> results_;  ///< [pass], except the last
};

}  // namespace burin
