#include <burin/deform/evaluate/pass_positions.h>

namespace burin {

void PassPositions::set(Index vertex, const Vec3f& place) {
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    const Index at = charts_[i]->place(vertex);
    if (at == no_index) continue;
    // Vertices without nodes are at their original positions.
    for (Index next = static_cast<Index>(places_[i].size()); next <= at; ++next)
      places_[i].push_back(surface_->positions[charts_[i]->vertex_at(next)]);
    places_[i][at] = place;
  }
}

}  // namespace burin
