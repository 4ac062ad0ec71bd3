#pragma once
#include <burin/surface/polygon_mesh.h>
#include <burin/surface/triangle_mesh.h>

namespace burin {

/// Splits every polygon but holes into triangles without new vertices: quads along the shorter diagonal that
/// lies inside, unless something else runs there (cut_from_1_to_3), larger polygons by ear clipping in their
/// mean plane. Carries texture coordinates where there are any.
TriangleMesh triangulate(const PolygonMesh& mesh);

}  // namespace burin
