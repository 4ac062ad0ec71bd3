#pragma once
#include <burin/base/vector.h>
#include <burin/surface/vertex_paint.h>

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// The behaviour of a subdivision surface at its boundary (OpenSubdiv's VtxBoundaryInterpolation).
enum class BoundaryRule {
  none,  ///< boundary faces are not part of the surface; they only shape the faces inside
  edges_only,
  edges_and_corners
};

/// How the sharpness of creases decreases from level to level (OpenSubdiv's CreasingMethod).
enum class CreaseMethod {
  uniform,
  chaikin,  ///< averaged along creases whose edges differ in sharpness
};

/// An edge that refinement keeps sharp.
struct CreaseEdge {
  Index a, b;
  float sharpness;  ///< 0 = smooth, >= 10 = infinitely sharp
};

/// A vertex that refinement keeps sharp.
struct CornerVertex {
  Index vertex;
  float sharpness;
};

/// A polygon mesh as read from a file: a control cage to refine, or a surface to triangulate.
struct PolygonMesh {
  std::vector<Vec3f> positions;   ///< [vertex] object units, relative to `origin`
  std::vector<Index> face_sizes;  ///< [face] number of corners, >= 3
  std::vector<Index>
      face_vertices;  ///< vertices of all corners, face by face, counter-clockwise from outside
  /// Added to a position it gives the file's position. Zero unless floats would round the file's positions
  /// noticeably; see read_mesh().
  Vec3d origin = Vec3d::Zero();
  /// [corner] texture coordinates, u to the right, v up; the unit square is the image. Empty unless all
  /// corners have them. Values are the file's own and may be NaN. An island ends where faces disagree at a
  /// vertex.
  std::vector<Vec2f> corner_uv;
  std::vector<CreaseEdge> creases;                   ///< OBJ tag `t crease`
  std::vector<CornerVertex> corners;                 ///< OBJ tag `t corner`
  std::vector<Index> holes;                          ///< faces to leave out of the surface; OBJ tag `t hole`
  BoundaryRule boundary = BoundaryRule::edges_only;  ///< OBJ tag `t interpolateboundary`: 0, 2 and 1
  CreaseMethod crease_method = CreaseMethod::uniform;  ///< OBJ tag `t creasemethod`: normal or chaikin
  VertexPaint paint;                                   ///< colours and masks of the vertices, if any
  /// Counts what the file holds but the reader ignores: "3 groups, 441 normals". Empty if there is nothing.
  std::string not_used;
};

}  // namespace burin
