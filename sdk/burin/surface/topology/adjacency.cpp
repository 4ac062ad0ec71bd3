// Builds the neighbourhoods of a mesh in compressed rows: a counting sort of corners by vertex, then the
// neighbours of each vertex from its triangles, sorted; O(n) for meshes of bounded valence, O(n log n) for
// others. The loops run on all threads.
#include <burin/base/counting_sort.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/topology/adjacency.h>
#include <burin/surface/topology/collect_rows.h>

#include <algorithm>
#include <array>

namespace burin {
namespace {

constexpr std::size_t vertices_per_block = 8192;

/// Appends the neighbours of `vertex`, ascending, for any arrangement of triangles.
void append_neighbours(std::span<const Triangle> triangles, std::span<const Index> around, Index vertex,
                       UnsetVector<Index>& out) {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  for (const Index triangle : around)
    for (const Index corner : triangles[triangle])
      if (corner != vertex) out.push_back(corner);
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
}

/// Appends the neighbours of `vertex`, ascending, if up to `most` triangles form one closed fan, as at nearly
/// all vertices; otherwise appends nothing and returns false. The sort has no branches, since they would be
/// unpredictable.
bool append_closed_fan(std::span<const Triangle> triangles, std::span<const Index> around, Index vertex,
                       UnsetVector<Index>& out) {
  constexpr std::size_t most = 8;
  if (around.size() > most) return false;
  std::array<Index, most> next{}, ranks{};
  next.fill(no_index);
  std::array<Index, most> previous = next;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Triangle& triangle = triangles[around[i]];
    const std::size_t corner = corner_of(triangle, vertex);
    next[i] = triangle[(corner + 1) % 3];
    previous[i] = triangle[(corner + 2) % 3];
  }
  Index equal = 0, rank_sum = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    Index rank = 0;
    for (std::size_t j = 0; j < most; ++j) {
      equal += next[j] == previous[i];
      rank += next[j] < next[i];
    }
    ranks[i] = rank;
    rank_sum += rank;
  }
  // The ranks of n corners are distinct if and only if they sum up to 0 + 1 + ... + (n - 1).
  const std::size_t size = around.size();
  if (equal != size || 2 * rank_sum != size * (size - 1)) return false;
  const std::size_t first = out.size();
  out.resize(first + size);
  for (std::size_t i = 0; i < size; ++i) out[first + ranks[i]] = next[i];
  return true;
}

}  // namespace

Csr incident_triangles(std::size_t vertices, std::span<const Triangle> triangles) {
  Csr incident;
  incident.items.resize(3 * triangles.size());
  incident.offsets = counting_sort(
      triangles.size(), vertices,
      [&](std::size_t i, const auto& emit) {
        for (const Index vertex : triangles[i]) emit(vertex);
      },
      [&](std::size_t i, std::size_t position) { incident.items[position] = static_cast<Index>(i); });
  return incident;
}

Csr neighbour_vertices(std::span<const Triangle> triangles, const Csr& incident) {
  return collect_rows(incident.rows(), vertices_per_block, [&](Index vertex, UnsetVector<Index>& out) {
    if (!append_closed_fan(triangles, incident[vertex], vertex, out))
      append_neighbours(triangles, incident[vertex], vertex, out);
  });
}

}  // namespace burin
