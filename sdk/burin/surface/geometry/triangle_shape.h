#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstddef>

namespace burin {

inline bool names_a_vertex_twice(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// False when the corners lie on one line, exactly.
bool has_area(const TriangleMesh& mesh, const Triangle& triangle);

/// Which corner of its triangle a vertex is. Without branches, which nobody could foresee.
inline std::size_t corner_of(const Triangle& triangle, Index vertex) {
  return std::size_t{triangle[1] == vertex} + 2 * std::size_t{triangle[2] == vertex};
}

}  // namespace burin
