#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// A cage's texture coordinates in which equal ones at a vertex share one number. OpenSubdiv finds the
/// islands by these numbers.
struct WeldedUv {
  std::vector<Vec2f> values;
  std::vector<Index> corners;  ///< [corner] index into values
};

/// Numbers the texture coordinates in the order of their first appearance. The cage must have texture
/// coordinates.
WeldedUv weld_uv(const PolygonMesh& cage);

}  // namespace burin
