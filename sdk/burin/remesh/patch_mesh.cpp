// Removes the vertices of a patch that no triangle has.
#include <burin/remesh/patch_mesh.h>

namespace burin {

PatchMesh without_unused_vertices(const PatchMesh& patch) {
  std::vector<bool> used(patch.positions.size(), false);
  for (const Triangle& triangle : patch.triangles)
    for (const Index vertex : triangle) used[vertex] = true;
  std::vector<Index> number(patch.positions.size(), no_index);
  PatchMesh left;
  for (Index v = 0; v < number.size(); ++v) {
    if (!used[v]) continue;
    number[v] = left.vertex_count();
    left.positions.push_back(patch.positions[v]);
    left.kept.push_back(patch.kept[v]);
  }
  for (const auto& [a, b, c] : patch.triangles) left.triangles.push_back({number[a], number[b], number[c]});
  return left;
}

}  // namespace burin
