#pragma once
#include <burin/surface/csr.h>

#include <span>

namespace burin {

/// The triangles around each of `vertices` vertices, ascending. No triangle may name a vertex twice.
Csr incident_triangles(std::size_t vertices, std::span<const Triangle> triangles);

/// The vertices that share an edge with each vertex, ascending, each once however many triangles share it.
Csr neighbour_vertices(std::span<const Triangle> triangles, const Csr& incident);

}  // namespace burin
