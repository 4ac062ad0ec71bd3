#pragma once
#include <burin/base/vector.h>

#include <vector>

namespace burin {

/// Vertices and triangles in the order of a file or of a refinement. Object units.
struct TriangleMesh {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
};

}  // namespace burin
