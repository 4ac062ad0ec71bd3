#pragma once
#include <burin/surface/polygon_mesh.h>

namespace burin::samples {

/// A ewer (a jug with a lip and one handle) as a closed cage of quads, about 2 units tall, y up, the lip
/// towards +x, the handle in the plane z = 0 on the other side. Foot, collar and rim are creased.
PolygonMesh ewer_cage();

}  // namespace burin::samples
