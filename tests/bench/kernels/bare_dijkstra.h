#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin::kernels {

/// The yardstick for charts: Dijkstra's algorithm along the edges of the surface, by a binary heap with lazy
/// deletion, and nothing else. Keeps its memory from run to run; a run costs in proportion to what it
/// reaches. The surface must outlive it.
class BareDijkstra {
 public:
  explicit BareDijkstra(const Surface& surface);

  /// The vertices whose distance to the curve is at most `radius` (object units), nearest first; valid until
  /// the next run. Starts from the corners around each point of the curve, straight away from the point.
  std::span<const Index> run(const SurfaceCurve& curve, float radius);

  /// The distance of a vertex in the last run; infinite if it was not reached.
  float distance(Index vertex) const { return distance_[vertex]; }

 private:
  const Surface* surface_;
  std::vector<float> distance_;  ///< [vertex]
  std::vector<Index> reached_;
};

}  // namespace burin::kernels
