#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/surface/vertex_paint.h>
#include <burin/volume/solid.h>

#include <span>
#include <vector>

#include "system/console.h"

namespace burin {

/// The surfaces of the solids that strokes made beside the surface.
class SolidParts {
 public:
  explicit SolidParts(std::span<const StrokeSolid> solids);

  bool empty() const { return meshes_.empty(); }

  /// Appends the parts to a mesh, and to its paint, bare, where it has some.
  void append_to(TriangleMesh& mesh, VertexPaint& paint) const;

  /// Voxel, vertices, triangles, volume and area of each, in object units.
  Json json() const;
  std::string text() const;

 private:
  std::vector<double> voxels_;
  std::vector<TriangleMesh> meshes_;
};

}  // namespace burin
