// Counts the defects of a mesh in O(n log n): those of edges and fans vertex by vertex, repeated triangles
// and positions by sorting.
#include <burin/base/parallel.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/topology/adjacency.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/topology/vertex_star.h>
#include <burin/surface/topology/weld.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace burin {
namespace {

std::size_t count_duplicates(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) std::sort(triangle.begin(), triangle.end());
  parallel_sort(triangles.begin(), triangles.end());
  return triangles.size() -
         static_cast<std::size_t>(std::unique(triangles.begin(), triangles.end()) - triangles.begin());
}

std::size_t count_duplicate_positions(const std::vector<Vec3f>& positions) {
  const std::vector<Index> first = first_at_position(positions);
  std::size_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i) count += first[i] != i;
  return count;
}

std::size_t count_unreferenced(const TriangleMesh& mesh) {
  std::vector<bool> referenced(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles)
    for (const Index vertex : triangle) referenced[vertex] = true;
  return static_cast<std::size_t>(std::ranges::count(referenced, false));
}

void add_triangle(Index index, const Triangle& t, Index vertex, VertexStar& star) {
  const std::size_t at = corner_of(t, vertex);
  star.add(index, t[(at + 2) % 3], t[(at + 1) % 3]);
}

/// Counts defects of edges and fans. Triangles that have a vertex twice are ignored.
void count_topology(const TriangleMesh& mesh, MeshDefects& defects) {
  std::vector<Triangle> triangles;
  std::ranges::remove_copy_if(mesh.triangles, std::back_inserter(triangles), has_repeated_vertex);
  const Csr incident = incident_triangles(mesh.positions.size(), triangles);
  VertexStar star;
  for (Index vertex = 0; vertex < incident.rows(); ++vertex) {
    star.clear();
    for (const Index index : incident[vertex]) add_triangle(index, triangles[index], vertex, star);
    star.connect();
    defects.non_manifold_vertices += star.fans() > 1;
    for (const StarEdge& edge : star.edges()) {
      if (edge.other < vertex) continue;
      defects.non_manifold_edges += edge.faces() > 2;
      defects.flipped_edges += edge.flipped();
    }
  }
}

/// The name of a count, singular and plural.
struct Name {
  std::size_t MeshDefects::*count;
  const char* one;
  const char* many;
};

constexpr Name names[] = {
    {&MeshDefects::non_manifold_edges, "non-manifold edge", "non-manifold edges"},
    {&MeshDefects::non_manifold_vertices, "non-manifold vertex", "non-manifold vertices"},
    {&MeshDefects::flipped_edges, "edge between flipped triangles", "edges between flipped triangles"},
    {&MeshDefects::degenerate_triangles, "degenerate triangle", "degenerate triangles"},
    {&MeshDefects::duplicate_triangles, "duplicate triangle", "duplicate triangles"},
    {&MeshDefects::duplicate_positions, "duplicate position", "duplicate positions"},
    {&MeshDefects::unreferenced_vertices, "unreferenced vertex", "unreferenced vertices"}};

}  // namespace

bool MeshDefects::any() const {
  return std::ranges::any_of(names, [&](const Name& name) { return this->*name.count > 0; });
}

std::string MeshDefects::text() const {
  std::string result;
  for (const Name& name : names) {
    const std::size_t count = this->*name.count;
    if (count == 0) continue;
    if (!result.empty()) result += ", ";
    result += fmt::format("{} {}", count, count == 1 ? name.one : name.many);
  }
  return result;
}

MeshDefects find_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  count_topology(mesh, defects);
  defects.degenerate_triangles =
      static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
        return has_repeated_vertex(t) || !has_area(mesh.positions, t);
      }));
  defects.duplicate_triangles = count_duplicates(mesh.triangles);
  defects.duplicate_positions = count_duplicate_positions(mesh.positions);
  defects.unreferenced_vertices = count_unreferenced(mesh);
  return defects;
}

}  // namespace burin
