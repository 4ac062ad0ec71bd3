#pragma once
#include <burin/host/c/burin.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <vector>

namespace burin::c {

/// Which triangles of a surface the faces of its caller became; 4 bytes a triangle.
class HiddenFaces {
 public:
  /// `triangles`: all that the faces were cut into, face by face, by the vertices of the original mesh.
  /// `triangle_face`: [of them] its face. The surface was made of them. O(n log n).
  HiddenFaces(const std::vector<Triangle>& triangles, const std::vector<Index>& triangle_face,
              Index face_count, const Surface& surface);

  Index face_count() const { return face_count_; }

  /// What Session::hide() takes to hide faces, of which `hidden` has a byte each.
  std::vector<bool> triangles(const std::uint8_t* hidden) const;

 private:
  Index face_count_;
  std::vector<Index> face_;  ///< [triangle of the surface]
};

}  // namespace burin::c
