// Undoes the order in which surfaces store vertices for locality.
#include "replay/source_order.h"

namespace burin {

TriangleMesh in_source_order(const Surface& surface, std::span<const Vec3f> positions) {
  const std::vector<Index>& source = surface.source_vertex;
  TriangleMesh mesh;
  mesh.positions.resize(positions.size());
  for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
    mesh.positions[source[vertex]] = positions[vertex];
  }
  mesh.triangles.reserve(surface.triangles.size());
  for (const Triangle& triangle : surface.triangles) {
    mesh.triangles.push_back({source[triangle[0]], source[triangle[1]], source[triangle[2]]});
  }
  mesh.triangle_uv = surface.triangle_uv;
  return mesh;
}

}  // namespace burin
