// A search over the vertices near a line. A number per vertex tells those that were seen, so that nothing is
// cleared between searches; the array is made anew for a surface of another size.
#include <burin/base/segment.h>
#include <burin/refine/coarse_edges.h>

namespace burin {

void CoarseEdges::visit(Index vertex) {
  if (seen_[vertex] == search_) return;
  seen_[vertex] = search_;
  open_.push_back(vertex);
}

bool CoarseEdges::are_near(const Surface& surface, Index triangle, const Vec3d& from, const Vec3d& to,
                           double reach, double longest) {
  if (seen_.size() != surface.vertex_count()) {
    seen_.assign(surface.vertex_count(), 0);
    search_ = 0;
  }
  ++search_;
  open_.clear();
  const auto is_within = [&](const Vec3d& place) {
    return (place - from - share_on_segment(from, to, place) * (to - from)).squaredNorm() <= reach * reach;
  };
  const auto place_of = [&](Index vertex) -> Vec3d { return surface.positions[vertex].cast<double>(); };
  const Triangle& start = surface.triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i)
    if ((place_of(start[i]) - place_of(start[(i + 1) % 3])).squaredNorm() > longest * longest) return true;
  for (const Index corner : start) visit(corner);
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const Vec3d place = place_of(open_[i]);
    if (i >= 3 && !is_within(place)) continue;
    for (const Index neighbour : surface.neighbours[open_[i]]) {
      if ((place_of(neighbour) - place).squaredNorm() > longest * longest) return true;
      visit(neighbour);
    }
  }
  return false;
}

}  // namespace burin
