#pragma once
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

#include <cstdint>
#include <vector>

namespace burin {

/// How a subdivision surface meets its boundary (OpenSubdiv's VtxBoundaryInterpolation).
enum class BoundaryRule { edges_only, edges_and_corners };

struct CreaseEdge {
  Index a, b;
  float sharpness;  ///< 0 = smooth, >= 10 = infinitely sharp
};

struct CornerVertex {
  Index vertex;
  float sharpness;
};

/// A mesh of polygons as its file has it: a cage to refine, or a surface to triangulate.
struct PolygonMesh {
  std::vector<Vec3f> positions;      ///< object units
  std::vector<Index> face_sizes;     ///< corners of each face, >= 3
  std::vector<Index> face_vertices;  ///< all corners, face after face, counter-clockwise from outside
  /// Texture coordinates [corner], u to the right, v up: the unit square is the image. Empty unless all
  /// corners have them. An island ends where faces disagree at a vertex.
  std::vector<Vec2f> corner_uv;
  std::vector<CreaseEdge> creases;                   ///< OBJ tag `t crease`
  std::vector<CornerVertex> corners;                 ///< OBJ tag `t corner`
  BoundaryRule boundary = BoundaryRule::edges_only;  ///< OBJ tag `t interpolateboundary`: 1 = corners too
  VertexPaint paint;                                 ///< on the vertices of a PLY file
};

}  // namespace burin
