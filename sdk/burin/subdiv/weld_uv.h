#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// A cage's texture coordinates with those that are the same at a vertex numbered as one, which is how
/// OpenSubdiv tells islands apart.
struct WeldedUv {
  std::vector<Vec2f> values;
  std::vector<Index> corners;  ///< [corner] its value
};

/// The values in order of first appearance. The cage must have texture coordinates.
WeldedUv weld_uv(const PolygonMesh& cage);

}  // namespace burin
