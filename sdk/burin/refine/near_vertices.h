#pragma once
#include <burin/surface/surface.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Goes over the vertices of a surface near a place: what an event of the pen asks. Reused from search to
/// search to keep its memory, a number per vertex of what saw it last, so that nothing is cleared.
class NearVertices {
 public:
  /// Whether `is_found(vertex)` holds for a corner of these triangles, or for a vertex to which the search
  /// goes on from these over neighbours `is_within(position)`. Costs O(vertices that are).
  template <class IsWithin, class IsFound>
  bool any(const Surface& surface, std::span<const Index> triangles, const IsWithin& is_within,
           const IsFound& is_found) {
    begin(surface);
    for (const Index triangle : triangles)
      for (const Index corner : surface.triangles[triangle]) visit(corner);
    const std::size_t corners = open_.size();
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (i >= corners && !is_within(surface.positions[open_[i]].cast<double>())) continue;
      if (is_found(open_[i])) return true;
      for (const Index neighbour : surface.neighbours[open_[i]]) visit(neighbour);
    }
    return false;
  }

 private:
  void begin(const Surface& surface) {
    if (seen_.size() != surface.vertex_count()) {
      seen_.assign(surface.vertex_count(), 0);
      search_ = 0;
    }
    ++search_;
    open_.clear();
  }
  void visit(Index vertex) {
    if (seen_[vertex] == search_) return;
    seen_[vertex] = search_;
    open_.push_back(vertex);
  }

  std::vector<Index> open_;
  std::vector<std::uint32_t> seen_;  ///< [vertex] the number of the search that saw it
  std::uint32_t search_ = 0;
};

}  // namespace burin
