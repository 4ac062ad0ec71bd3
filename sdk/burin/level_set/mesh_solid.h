#pragma once
#include <burin/surface/triangle_mesh.h>
#include <burin/volume/solid.h>

#include <cstddef>

namespace burin {

/// The solid that a closed mesh bounds, in voxels of this edge, object units: all that cannot be reached from
/// outside, so that parts of the mesh that overlap are united. Values are distances in space. Throws Error
/// where the mesh is open, the voxel is none, or the voxels would take more than `most_bytes`, before they
/// are made. On all threads; the bits do not depend on their number.
StrokeSolid solid_of(const TriangleMesh& mesh, double voxel, std::size_t most_bytes = std::size_t{2} << 30);

}  // namespace burin
