#pragma once
#include <burin/surface/triangle_mesh.h>

#include <functional>

namespace burin {

/// A net of columns x rows quads of two triangles each. `place` gives the vertex at (u, v), both from -1 to
/// 1; normals point to where u, v and they are right-handed.
TriangleMesh grid_mesh(Index columns, Index rows, const std::function<Vec3f(double u, double v)>& place);

}  // namespace burin
