#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/surface/vertex_paint.h>
#include <burin/volume/solid.h>

#include <span>
#include <vector>

#include "system/console.h"

namespace burin {

/// What strokes made beside the surface: the surfaces of solids, then meshes that were bent along strokes.
class SolidParts {
 public:
  SolidParts(std::span<const StrokeSolid> solids, std::span<const TriangleMesh> bent);

  bool empty() const { return meshes_.empty(); }

  /// Appends the parts to a mesh, and to its paint, bare, where it has some.
  void append_to(TriangleMesh& mesh, VertexPaint& paint) const;

  /// Vertices, triangles, volume and area of each, and the voxel of those of solids, in object units.
  Json json() const;
  std::string text() const;

 private:
  std::vector<double> voxels_;  ///< [i] of meshes_[i]; of solids only
  std::vector<TriangleMesh> meshes_;
};

}  // namespace burin
