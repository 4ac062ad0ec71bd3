#pragma once
#include <burin/deform/blend/blend.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/evaluate/pass_places.h>

#include <span>
#include <vector>

namespace burin {

/// One symmetry instance of a stroke, to be evaluated.
struct EvaluatedInstance {
  NodeSource source;
  burin_stroke_context context{};
  float strength = 1;
  NodeOutputs& outputs;  ///< [slot], of the chart's size
};

/// The passes of a brush that looks at neighbours: what the one before left, at every node and vertex, so
/// that an event computes again only what its changes reach: each pass carries them one neighbour farther.
class StrokePasses {
 public:
  /// All must outlive the object; `charts`: those of the stroke's instances.
  StrokePasses(const Surface& surface, const BrushStroke& stroke, std::vector<const LiveChart*> charts,
               const BlendOptions& blend);

  /// Follows changes at these vertices, of which all that have or had stale nodes: sets the outputs of all
  /// nodes that they reach. Returns the vertices of these, ascending. Throws as Evaluator.
  std::vector<Index> update(Evaluator& evaluator, std::span<EvaluatedInstance> instances,
                            std::vector<Index> vertices);

 private:
  /// What a pass left.
  struct Left {
    std::vector<NodeOutputs> outputs;  ///< [instance] [slot]
    PassPlaces places;
  };
  void add_neighbours(std::vector<Index>& vertices) const;
  void run(std::uint32_t pass, Evaluator& evaluator, std::span<EvaluatedInstance> instances,
           std::span<const Index> vertices);
  void place(std::uint32_t pass, std::span<const EvaluatedInstance> instances,
             std::span<const Index> vertices);

  const Surface* surface_;
  const BrushStroke* stroke_;
  std::vector<const LiveChart*> charts_;
  BlendOptions blend_;
  std::vector<Left> left_;  ///< [pass] but the last
};

}  // namespace burin
