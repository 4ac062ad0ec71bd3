#pragma once
#include <burin/surface/triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace burin {

inline bool has_repeated_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Whether the corners do not lie exactly on one line.
bool has_area(const std::vector<Vec3f>& positions, const Triangle& triangle);

/// The index, 0 to 2, of a vertex among the corners of its triangle. It has no branches, since they would be
/// unpredictable.
inline std::size_t corner_of(const Triangle& triangle, Index vertex) {
  return std::size_t{triangle[1] == vertex} + 2 * std::size_t{triangle[2] == vertex};
}

}  // namespace burin
