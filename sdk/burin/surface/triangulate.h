#pragma once
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// Splits every face except holes into triangles without new vertices. Quads are split along the shorter
/// diagonal that lies inside, unless it coincides with another edge (see cut_from_1_to_3()); larger polygons
/// by ear clipping in their mean plane. Texture coordinates are preserved. Faces must have at least three
/// corners.
TriangleMesh triangulate(const PolygonMesh& mesh);

}  // namespace burin
