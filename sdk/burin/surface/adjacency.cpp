#include <burin/base/counting_sort.h>
#include <burin/base/parallel.h>
#include <burin/surface/adjacency.h>
#include <burin/surface/triangle_shape.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace burin {
namespace {

constexpr std::size_t vertices_a_block = 8192;

/// Appends the vertices beside `vertex`, ascending.
void append_neighbours(std::span<const Triangle> triangles, std::span<const Index> around, Index vertex,
                       UnsetVector<Index>& out) {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  for (const Index triangle : around)
    for (const Index corner : triangles[triangle])
      if (corner != vertex && std::find(out.begin() + first, out.end(), corner) == out.end())
        out.push_back(corner);
  std::sort(out.begin() + first, out.end());
}

/// The same where up to `most` triangles make one closed fan, as at nearly all vertices; else false and
/// nothing. A sort without branches, as none of them could be foreseen.
bool append_closed_fan(std::span<const Triangle> triangles, std::span<const Index> around, Index vertex,
                       UnsetVector<Index>& out) {
  constexpr std::size_t most = 8;
  if (around.size() > most) return false;
  std::array<Index, most> next, ranks{};
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
  // Ranks tell n corners apart where they sum up to 0 + 1 + ... + (n - 1).
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
  Csr result;
  result.offsets.resize(incident.rows() + std::size_t{1});
  std::vector<UnsetVector<Index>> found(incident.rows() / vertices_a_block + 1);  // [block]
  parallel_blocks(incident.rows(), vertices_a_block, [&](std::size_t begin, std::size_t end) {
    UnsetVector<Index>& neighbours = found[begin / vertices_a_block];
    neighbours.reserve(incident.offsets[end] - incident.offsets[begin]);
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex) {
      const std::size_t before = neighbours.size();
      if (!append_closed_fan(triangles, incident[vertex], vertex, neighbours))
        append_neighbours(triangles, incident[vertex], vertex, neighbours);
      result.offsets[vertex + 1] = static_cast<Index>(neighbours.size() - before);
    }
  });
  std::inclusive_scan(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  parallel_blocks(found.size(), 1, [&](std::size_t block, std::size_t) {
    std::ranges::copy(found[block], result.items.begin() + result.offsets[block * vertices_a_block]);
  });
  return result;
}

}  // namespace burin
