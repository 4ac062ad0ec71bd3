// The edges of a vertex are found in its triangles, each once or twice, and sorted by their other end.
#include <burin/base/parallel.h>
#include <burin/refine/given_shape.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t block = 4096;

/// An end of an edge, and the squared distance from its middle to the nearest corner of a triangle at it.
using EdgeGap = std::pair<Index, float>;

/// `edges`: to work in.
float gap_at(const Surface& surface, std::span<const Vec3f> positions, Index vertex,
             std::vector<EdgeGap>& edges) {
  edges.clear();
  const Vec3f& at = positions[vertex];
  const auto add = [&](Index end, Index apex) {
    const Vec3f half = (positions[end] - at) / 2;
    const float to_apex = (positions[apex] - at - half).squaredNorm();
    edges.emplace_back(end, std::min(half.squaredNorm(), to_apex));
  };
  for (const Index triangle : surface.incident[vertex]) {
    const Triangle& t = surface.triangles[triangle];
    const std::size_t i = corner_of(t, vertex);
    const Index next = t[(i + 1) % 3], last = t[(i + 2) % 3];
    add(next, last);
    add(last, next);
  }
  std::ranges::sort(edges);
  // The first one of an edge is the least.
  float greatest = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (i == 0 || edges[i].first != edges[i - 1].first) greatest = std::max(greatest, edges[i].second);
  return 2 * std::sqrt(greatest);
}

/// The greatest gap at a vertex as it is and as it was given, whichever is less. `edges`: to work in.
float gap_now(const Surface& after, std::span<const Vec3f> given, Index vertex, std::vector<EdgeGap>& edges) {
  const float now = gap_at(after, after.positions, vertex, edges);
  return given.empty() ? now : std::min(now, gap_at(after, given, vertex, edges));
}

}  // namespace

GivenShape::GivenShape(const Surface& surface) : gaps_(surface.vertex_count()) {
  parallel_blocks(gaps_.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<EdgeGap> edges;
    for (std::size_t v = begin; v < end; ++v)
      gaps_[v] = gap_at(surface, surface.positions, static_cast<Index>(v), edges);
  });
  find_extremes();
}

void GivenShape::keep_positions(const Surface& surface) {
  if (positions_.empty()) positions_ = surface.positions;
}

void GivenShape::exchange(KeptEdges& kept) {
  if (kept.vertices.empty()) return;
  for (std::size_t i = 0; i < kept.vertices.size(); ++i) std::swap(edges_[kept.vertices[i]], kept.edges[i]);
  find_extremes();
}

/// All but the gaps of vertices, which are those that they had; of new ones 0.
GivenShape GivenShape::carried(const Surface& after, std::span<const Index> came_from,
                               const AddedVertices& added) const {
  const auto old_count = static_cast<Index>(gaps_.size());
  GivenShape made;
  made.gaps_.resize(came_from.size());
  if (!positions_.empty()) made.positions_ = after.positions;
  if (!edges_.empty() || !added.edges.empty()) made.edges_.resize(came_from.size());
  for (Index vertex = 0; vertex < came_from.size(); ++vertex) {
    const Index from = came_from[vertex];
    const bool is_old = from < old_count;
    if (is_old) made.gaps_[vertex] = gaps_[from];
    if (!positions_.empty() && (is_old || !added.given.empty()))
      made.positions_[vertex] = is_old ? positions_[from] : added.given[from - old_count];
    if (is_old && !edges_.empty()) made.edges_[vertex] = edges_[from];
    if (!is_old && !added.edges.empty()) made.edges_[vertex] = added.edges[from - old_count];
  }
  return made;
}

GivenShape GivenShape::patched(const Surface& after, std::span<const Index> came_from,
                               const AddedVertices& added) const {
  GivenShape made = carried(after, came_from, added);
  const auto is_new = [&](Index vertex) { return came_from[vertex] >= gaps_.size(); };
  parallel_blocks(came_from.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<EdgeGap> edges;
    for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex) {
      if (is_new(vertex))
        made.gaps_[vertex] = gap_now(after, made.positions_, vertex, edges);
      else if (std::ranges::any_of(after.neighbours[vertex], is_new))
        made.gaps_[vertex] = std::min(made.gaps_[vertex], gap_now(after, made.positions_, vertex, edges));
    }
  });
  made.find_extremes();
  return made;
}

GivenShape GivenShape::coarsened(const Surface& after, std::span<const Index> came_from,
                                 std::span<const Index> changed) const {
  GivenShape made = carried(after, came_from, {});
  parallel_blocks(came_from.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<EdgeGap> edges;
    for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      if (std::ranges::binary_search(changed, came_from[vertex]))
        made.gaps_[vertex] = gap_now(after, made.positions_, vertex, edges);
  });
  made.find_extremes();
  return made;
}

void GivenShape::find_extremes() {
  greatest_ = 0;
  for (const float gap : gaps_) greatest_ = std::max(greatest_, gap);
  least_edge_ = std::numeric_limits<float>::infinity();
  for (const float edge : edges_)
    if (edge > 0) least_edge_ = std::min(least_edge_, edge);
}

}  // namespace burin
