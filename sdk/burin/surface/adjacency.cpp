#include <burin/base/parallel.h>
#include <burin/surface/adjacency.h>

#include <algorithm>
#include <numeric>

namespace burin {
namespace {

constexpr std::size_t vertices_a_block = 8192;

/// Turns counts stored at [row + 1] into offsets and makes room for the items.
void allocate_rows(Csr& csr) {
  std::inclusive_scan(csr.offsets.begin(), csr.offsets.end(), csr.offsets.begin());
  csr.items.resize(csr.offsets.back());
}

/// Sets `out` to the vertices beside `vertex`, ascending.
void gather_neighbours(std::span<const Triangle> triangles, std::span<const Index> around, Index vertex,
                       std::vector<Index>& out) {
  out.clear();
  for (const Index triangle : around)
    for (const Index corner : triangles[triangle])
      if (corner != vertex) out.push_back(corner);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

/// Calls body(vertex, its neighbours) for every vertex, in parallel.
template <class Body>
void for_each_neighbourhood(std::span<const Triangle> triangles, const Csr& incident, const Body& body) {
  parallel_blocks(incident.rows(), vertices_a_block, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> neighbours;
    for (Index vertex = static_cast<Index>(begin); vertex < end; ++vertex) {
      gather_neighbours(triangles, incident[vertex], vertex, neighbours);
      body(vertex, neighbours);
    }
  });
}

}  // namespace

Csr incident_triangles(std::size_t vertices, std::span<const Triangle> triangles) {
  Csr incident;
  incident.offsets.assign(vertices + 1, 0);
  for (const Triangle& triangle : triangles)
    for (const Index vertex : triangle) ++incident.offsets[vertex + 1];
  allocate_rows(incident);

  // offsets[v] serves as the write position of row v, ends at the row's end, and is shifted back after.
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const Index vertex : triangles[i])
      incident.items[incident.offsets[vertex]++] = static_cast<Index>(i);
  std::shift_right(incident.offsets.begin(), incident.offsets.end(), 1);
  incident.offsets.front() = 0;
  return incident;
}

Csr neighbour_vertices(std::span<const Triangle> triangles, const Csr& incident) {
  Csr result;
  result.offsets.assign(incident.rows() + std::size_t{1}, 0);
  for_each_neighbourhood(triangles, incident, [&](Index vertex, const std::vector<Index>& neighbours) {
    result.offsets[vertex + 1] = static_cast<Index>(neighbours.size());
  });
  allocate_rows(result);
  for_each_neighbourhood(triangles, incident, [&](Index vertex, const std::vector<Index>& neighbours) {
    std::copy(neighbours.begin(), neighbours.end(), result.items.begin() + result.offsets[vertex]);
  });
  return result;
}

}  // namespace burin
