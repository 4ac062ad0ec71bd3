#pragma once
#include <burin/base/vector.h>
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// The surface as a mesh with its vertices at `positions`, in the vertex order of the original mesh, and with
/// its texture coordinates.
TriangleMesh in_source_order(const Surface& surface, std::span<const Vec3f> positions);

}  // namespace burin
