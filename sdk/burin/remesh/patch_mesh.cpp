// Removes the vertices of a patch that no triangle has, and measures angles.
#include <burin/remesh/patch_mesh.h>

#include <algorithm>

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

double worst_cosine(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c;
  const double lengths[] = {ab.norm(), bc.norm(), ca.norm()};
  if (!(std::min({lengths[0], lengths[1], lengths[2]}) > 0)) return 1;
  return std::max({-ab.dot(ca) / (lengths[0] * lengths[2]), -ab.dot(bc) / (lengths[0] * lengths[1]),
                   -bc.dot(ca) / (lengths[1] * lengths[2])});
}

}  // namespace burin
