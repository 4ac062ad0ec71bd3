#pragma once
#include <burin/along/copies.h>
#include <burin/along/source_part.h>
#include <burin/surface/triangle_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// Meshes laid along a straight stroke: where they are before it bends them. Object units.
struct LaidMesh {
  std::vector<Vec3d> points;  ///< [vertex] (t, across to the left, up); across and up before twist and width
  std::vector<Triangle> triangles;
  std::vector<TriangleUv> triangle_uv;  ///< [triangle], or empty
};

/// The frame in which parts are laid: the point of the meshes at the middle of the stroke, on the surface,
/// and object units per unit of the meshes.
struct LaidFrame {
  double across = 0, up = 0, scale = 1;
};

/// Adds one copy of a part. Points at the ends of the part get the t of the ends of the interval, to the bit.
/// `with_uv`: texture coordinates of 0 stand for those that the part lacks.
void lay(const SourcePart& part, const CopyInterval& interval, const LaidFrame& frame, bool with_uv,
         LaidMesh& into);

}  // namespace burin
