#pragma once
#include <burin/surface/polygon_mesh.h>

namespace burin::samples {

/// One period of a plait of three strands along x, y up, open at both ends, where it fits to itself.
PolygonMesh plait();

}  // namespace burin::samples
