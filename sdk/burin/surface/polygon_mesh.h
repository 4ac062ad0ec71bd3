#pragma once
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// How a subdivision surface meets its boundary (OpenSubdiv's VtxBoundaryInterpolation).
enum class BoundaryRule {
  none,  ///< it ends where faces at the boundary begin: those only shape the ones inside
  edges_only,
  edges_and_corners
};

/// How the sharpness of creases fades from level to level (OpenSubdiv's CreasingMethod).
enum class CreaseMethod {
  uniform,
  chaikin,  ///< smoothed along the crease, where its edges differ
};

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
  std::vector<Vec3f> positions;      ///< object units, from `origin` on
  std::vector<Index> face_sizes;     ///< corners of each face, >= 3
  std::vector<Index> face_vertices;  ///< all corners, face after face, counter-clockwise from outside
  /// What to add to all positions for the places of the file; zero unless those lie so far away that floats
  /// would round them. See read_mesh.
  Vec3d origin = Vec3d::Zero();
  /// Texture coordinates [corner], u to the right, v up: the unit square is the image. Empty unless all
  /// corners have them; as the file has them, not a number too. An island ends where faces disagree at a
  /// vertex.
  std::vector<Vec2f> corner_uv;
  std::vector<CreaseEdge> creases;                   ///< OBJ tag `t crease`
  std::vector<CornerVertex> corners;                 ///< OBJ tag `t corner`
  std::vector<Index> holes;                          ///< faces that are none of the surface; OBJ tag `t hole`
  BoundaryRule boundary = BoundaryRule::edges_only;  ///< OBJ tag `t interpolateboundary`: 0, 2 and 1
  CreaseMethod crease_method = CreaseMethod::uniform;  ///< OBJ tag `t creasemethod`: normal or chaikin
  VertexPaint paint;                                   ///< on the vertices, where the file has any
  /// What the file holds besides, counted: "3 groups, 441 normals". Empty for nothing.
  std::string not_used;
};

}  // namespace burin
