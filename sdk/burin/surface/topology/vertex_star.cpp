// Finds the edges and fans around a vertex: the sides of its faces are sorted, so that those at one edge are
// consecutive, and faces with a common edge are united by union-find with path halving.
#include <burin/surface/topology/vertex_star.h>

#include <algorithm>
#include <numeric>

namespace burin {

Index VertexStar::fan_of(Index corner) {
  while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
  return corner;
}

void VertexStar::join(Index a, Index b) {
  a = fan_of(a);
  b = fan_of(b);
  if (a == b) return;
  parents_[std::max(a, b)] = std::min(a, b);
  --fans_;
}

void VertexStar::connect() {
  sides_.clear();
  for (Index i = 0; i < corners_.size(); ++i) {
    sides_.push_back({corners_[i].previous, i, false});
    sides_.push_back({corners_[i].next, i, true});
  }
  std::sort(sides_.begin(), sides_.end());
  parents_.resize(corners_.size());
  std::iota(parents_.begin(), parents_.end(), Index{0});
  fans_ = static_cast<int>(corners_.size());
  edges_.clear();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const bool same_edge = i > 0 && sides_[i].other == sides_[i - 1].other;
    if (!same_edge) edges_.push_back({sides_[i].other});
    if (same_edge) join(sides_[i].corner, sides_[i - 1].corner);
    StarEdge& edge = edges_.back();
    ++(sides_[i].outward ? edge.outward : edge.inward);
    (same_edge ? edge.other_face : edge.face) = corners_[sides_[i].corner].face;
  }
}

}  // namespace burin
