#pragma once
#include <burin/along/copies.h>
#include <burin/along/laid_mesh.h>
#include <burin/surface/triangle_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// The bent mesh, in which copies that lie end to end and are open there are one piece: vertices at the ends
/// of copies, at open edges, become one where they were laid to the same point to the bit. `bent`: [vertex]
/// positions. `loop`: the length of a closed stroke, around which t is counted; 0: it is not closed.
TriangleMesh joined_copies(LaidMesh laid, std::span<const Vec3d> bent,
                           std::span<const CopyInterval> intervals, double loop);

}  // namespace burin
