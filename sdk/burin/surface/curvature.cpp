#include <burin/base/parallel.h>
#include <burin/surface/curvature.h>

#include <cstddef>

namespace burin {

float gauss_curvature(const Surface& surface, Index vertex) {
  const Vec3f& normal = surface.normals[vertex];
  float swept = 0, area = 0;
  for (const Index triangle : surface.incident[vertex]) {
    const auto& [a, b, c] = surface.triangles[triangle];
    const auto doubled = [&](const std::vector<Vec3f>& at) {
      return (at[b] - at[a]).cross(at[c] - at[a]).dot(normal);
    };
    swept += doubled(surface.normals);
    area += doubled(surface.positions);
  }
  return area > 0 ? swept / area : 0;
}

void update_gauss_curvature(Surface& surface, std::span<const Index> vertices) {
  constexpr std::size_t vertices_a_block = 2048;
  parallel_blocks(vertices.size(), vertices_a_block, [&](std::size_t begin, std::size_t end) {
    for (const Index vertex : vertices.subspan(begin, end - begin))
      surface.gauss_curvature[vertex] = gauss_curvature(surface, vertex);
  });
}

}  // namespace burin
