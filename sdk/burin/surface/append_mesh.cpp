// Concatenates vertices, and triangles with their indices moved, in O(appended mesh).
#include <burin/surface/append_mesh.h>

namespace burin {

void append(const TriangleMesh& part, TriangleMesh& into) {
  const TriangleUv none{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
  const bool with_uv = !part.triangle_uv.empty() || !into.triangle_uv.empty();
  if (with_uv) into.triangle_uv.resize(into.triangles.size(), none);
  const auto first = static_cast<Index>(into.positions.size());
  into.positions.insert(into.positions.end(), part.positions.begin(), part.positions.end());
  for (const Triangle& t : part.triangles)
    into.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  if (!with_uv) return;
  into.triangle_uv.insert(into.triangle_uv.end(), part.triangle_uv.begin(), part.triangle_uv.end());
  into.triangle_uv.resize(into.triangles.size(), none);
}

}  // namespace burin
