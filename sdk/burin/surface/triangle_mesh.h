#pragma once
#include <burin/base/vector.h>

#include <vector>

namespace burin {

/// Texture coordinates at the corners of a triangle.
using TriangleUv = std::array<Vec2f, 3>;

/// Vertices and triangles in the order of a file or of a refinement. Positions are in object units.
struct TriangleMesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  std::vector<TriangleUv> triangle_uv = {};  ///< [triangle], or empty; see PolygonMesh::corner_uv
};

}  // namespace burin
