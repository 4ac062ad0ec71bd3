// Stores positions by local index in the charts, so that memory grows with the stroke only.
#include <burin/deform/evaluate/pass_positions.h>

namespace burin {

void PassPositions::set(Index vertex, const Vec3f& position) {
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    const Index local = charts_[i]->local_index(vertex);
    if (local == no_index) continue;
    // Vertices without nodes are at their original positions.
    for (Index next = static_cast<Index>(positions_[i].size()); next <= local; ++next)
      positions_[i].push_back(surface_->positions[charts_[i]->vertex_at(next)]);
    positions_[i][local] = position;
  }
}

}  // namespace burin
