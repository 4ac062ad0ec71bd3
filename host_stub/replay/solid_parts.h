#pragma once
#include <burin/host/session.h>
#include <burin/surface/triangle_mesh.h>
#include <burin/surface/vertex_paint.h>

#include <span>
#include <string>
#include <vector>

#include "system/console.h"

namespace burin {

/// What strokes made beside the surface, as part_meshes() lists it.
class SolidParts {
 public:
  explicit SolidParts(const Session& session);

  bool empty() const { return meshes_.empty(); }
  std::span<const TriangleMesh> meshes() const { return meshes_; }

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
