// The edges of a vertex are found in its triangles, each once or twice, and sorted by their other end.
#include <burin/base/parallel.h>
#include <burin/refine/vertex_gaps.h>
#include <burin/surface/geometry/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t block = 4096;

/// An end of an edge, and the squared distance from its middle to the nearest corner of a triangle at it.
using EdgeGap = std::pair<Index, float>;

/// `edges`: to work in.
float gap_at(const Surface& surface, Index vertex, std::vector<EdgeGap>& edges) {
  edges.clear();
  const Vec3f& at = surface.positions[vertex];
  const auto add = [&](Index end, Index apex) {
    const Vec3f half = (surface.positions[end] - at) / 2;
    const float to_apex = (surface.positions[apex] - at - half).squaredNorm();
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

}  // namespace

VertexGaps::VertexGaps(const Surface& surface) : gaps_(surface.vertex_count()) {
  parallel_blocks(gaps_.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<EdgeGap> edges;
    for (std::size_t v = begin; v < end; ++v) gaps_[v] = gap_at(surface, static_cast<Index>(v), edges);
  });
  find_greatest();
}

VertexGaps VertexGaps::patched(const Surface& after, std::span<const Index> came_from, Fresh fresh) const {
  VertexGaps made;
  std::vector<EdgeGap> edges;
  for (Index vertex = 0; vertex < came_from.size(); ++vertex) {
    const Index from = came_from[vertex];
    if (from < gaps_.size())
      made.gaps_.push_back(gaps_[from]);
    else if (fresh == Fresh::refined)
      made.gaps_.push_back(std::numeric_limits<float>::infinity());
    else
      made.gaps_.push_back(gap_at(after, vertex, edges));
  }
  made.find_greatest();
  return made;
}

void VertexGaps::find_greatest() { greatest_ = gaps_.empty() ? 0 : std::ranges::max(gaps_); }

}  // namespace burin
