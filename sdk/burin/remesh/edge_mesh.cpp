// Converts a patch of triangles to OpenMesh's half-edges and back.
#include <burin/base/error.h>
#include <burin/remesh/edge_mesh.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {

EdgeMesh to_edges(const PatchMesh& patch) {
  // What it would write to the terminal is thrown instead.
  omerr().disable();
  EdgeMesh mesh;
  for (std::size_t v = 0; v < patch.positions.size(); ++v) {
    const auto vertex = add_vertex(mesh, patch.positions[v]);
    mesh.data(vertex).kept = patch.kept[v];
  }
  const auto handle = [](Index vertex) { return EdgeMesh::VertexHandle(static_cast<int>(vertex)); };
  for (const auto& [a, b, c] : patch.triangles) {
    if (mesh.add_face(handle(a), handle(b), handle(c)).is_valid()) continue;
    const Vec3d& at = patch.positions[a];
    throw Error(
        fmt::format("the surface is no manifold at ({:.6g}, {:.6g}, {:.6g})", at.x(), at.y(), at.z()));
  }
  return mesh;
}

PatchMesh to_patch(EdgeMesh& mesh) {
  PatchMesh patch;
  std::vector<Index> number(mesh.n_vertices(), no_index);
  for (const auto vertex : mesh.vertices()) {
    number[static_cast<std::size_t>(vertex.idx())] = patch.vertex_count();
    patch.positions.push_back(mesh.data(vertex).position);
    patch.kept.push_back(mesh.data(vertex).kept);
  }
  for (const auto face : mesh.faces()) {
    Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : mesh.fv_range(face))
      triangle[corner++] = number[static_cast<std::size_t>(vertex.idx())];
    patch.triangles.push_back(triangle);
  }
  return patch;
}

}  // namespace burin
