#pragma once
#include <burin/surface/surface.h>

namespace burin {

/// Vertices of triangles - edges + triangles of a surface: 2 for a sphere, 2 less for each handle, 1 less for
/// each hole. In O(n).
long euler_characteristic(const Surface& surface);

}  // namespace burin
