#pragma once
#include <burin/surface/csr.h>

#include <span>

namespace burin {

/// The triangles around each of `vertices` vertices, ascending. No triangle may have a vertex twice.
Csr incident_triangles(std::size_t vertices, std::span<const Triangle> triangles);

/// The vertices that share an edge with each vertex, ascending and without repetition. `incident` is the
/// result of incident_triangles().
Csr neighbour_vertices(std::span<const Triangle> triangles, const Csr& incident);

}  // namespace burin
