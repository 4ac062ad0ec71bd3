// Joins copies of a mesh that lie end to end: sorts the open vertices at the ends of copies by where they
// were laid, and makes one vertex of those that were laid to the same bits.
#include <burin/along/join_copies.h>
#include <burin/base/parallel.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace burin {
namespace {

using Edge = std::pair<Index, Index>;

/// Vertices at edges of one triangle only, ascending.
std::vector<Index> open_vertices(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  parallel_sort(edges.begin(), edges.end());
  std::vector<Index> open;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) open.insert(open.end(), {edges[i].first, edges[i].second});
    i = next;
  }
  std::ranges::sort(open);
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}

/// Arc lengths at which copies begin or end, ascending.
std::vector<double> ends_of(std::span<const CopyInterval> intervals) {
  std::vector<double> ends;
  for (const CopyInterval& interval : intervals) ends.insert(ends.end(), {interval.begin, interval.end});
  std::ranges::sort(ends);
  return ends;
}

/// A vertex at the end of a copy, by where it was laid: t, across, up.
using Candidate = std::tuple<double, double, double, Index>;

bool same_point(const Candidate& a, const Candidate& b) {
  return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b) &&
         std::get<2>(a) == std::get<2>(b);
}

/// The vertex that each becomes.
std::vector<Index> joins(const LaidMesh& laid, std::span<const CopyInterval> intervals, double loop) {
  const std::vector<double> ends = ends_of(intervals);
  std::vector<Candidate> candidates;
  for (const Index vertex : open_vertices(laid.triangles)) {
    const Vec3d& at = laid.points[vertex];
    if (!std::ranges::binary_search(ends, at.x())) continue;
    candidates.emplace_back(at.x() == loop ? 0 : at.x(), at.y(), at.z(), vertex);
  }
  std::ranges::sort(candidates);
  std::vector<Index> joined(laid.points.size());
  std::iota(joined.begin(), joined.end(), Index{0});
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (same_point(candidates[i], candidates[i - 1]))
      joined[std::get<3>(candidates[i])] = joined[std::get<3>(candidates[i - 1])];
  return joined;
}

}  // namespace

TriangleMesh joined_copies(LaidMesh laid, std::span<const Vec3d> bent,
                           std::span<const CopyInterval> intervals, double loop) {
  const std::vector<Index> joined = joins(laid, intervals, loop);
  TriangleMesh mesh{{}, std::move(laid.triangles), std::move(laid.triangle_uv)};
  std::vector<Index> number(bent.size(), no_index);
  for (Triangle& triangle : mesh.triangles) {
    for (Index& vertex : triangle) {
      Index& at = number[joined[vertex]];
      if (at == no_index) {
        at = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(bent[joined[vertex]].cast<float>());
      }
      vertex = at;
    }
  }
  return mesh;
}

}  // namespace burin
