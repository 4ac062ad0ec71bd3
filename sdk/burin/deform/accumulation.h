#pragma once
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/deform/evaluate/current_base.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/stroke_passes.h>

#include <span>
#include <vector>

namespace burin {

/// Evaluates strokes that accumulate on their own result (Accumulate::from_current). A visit starts from the
/// surface after all visits that are at least half a radius before it along the stroke. Outputs remain
/// displacements from the surface before the stroke, so that their sum gives the result.
class Accumulation {
 public:
  /// Surface and stroke must outlive the object; the stroke has a single pass. `radius` is that of the
  /// stroke, object units; 0 for dabs, each of which is a visit of its own.
  Accumulation(const Surface& surface, const BrushStroke& stroke, double radius)
      : surface_(&surface), stroke_(&stroke), apart_(radius / 2) {}

  /// Applies changes at these vertices: sets the outputs of the instance's nodes there, and of all later
  /// nodes that depend on them. Appends the vertices of these nodes to `reached`. Throws as Evaluator.
  void update(Evaluator& evaluator, EvaluatedInstance& instance, const LiveChart& chart,
              std::span<const Index> vertices, std::vector<Index>& reached) const;

 private:
  /// A node to compute, and the length of the longest chain of due nodes on which it depends.
  struct Due {
    Index slot;
    int after;
  };
  std::vector<Due> due_nodes(const LiveChart& chart, std::span<const Index> vertices) const;
  void add_later(const LiveChart& chart, std::span<const Index> from, std::vector<Index>& slots) const;
  template <class Visit>
  void for_each_around(const LiveChart& chart, Index slot, const Visit& visit) const;
  template <class Visit>
  void for_each_earlier(const LiveChart& chart, Index slot, const Visit& visit) const;
  bool earlier(const Chart& nodes, Index a, Index b) const;
  CurrentBase::Geometry geometry_of(const EvaluatedInstance& instance, const LiveChart& chart,
                                    Index slot) const;
  Vec3f left_at(Vec3f position, const EvaluatedInstance& instance, const LiveChart& chart, Index vertex,
                Index slot) const;
  void evaluate(Evaluator& evaluator, EvaluatedInstance& instance, const LiveChart& chart,
                std::span<const Index> slots) const;

  const Surface* surface_;
  const BrushStroke* stroke_;
  double apart_;  ///< smallest difference of t between two visits, object units
};

}  // namespace burin
