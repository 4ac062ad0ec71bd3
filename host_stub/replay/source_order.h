#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// The surface with its vertices at `positions` and in the order of the mesh that it was made of.
TriangleMesh in_source_order(const Surface& surface, std::span<const Vec3f> positions);

}  // namespace burin
