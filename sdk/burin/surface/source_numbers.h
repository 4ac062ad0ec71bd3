#pragma once
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// [vertex of the mesh that the surface was made of] its number on the surface: the inverse of
/// Surface::source_vertex.
inline std::vector<Index> numbers_of_source(const Surface& surface) {
  std::vector<Index> numbers(surface.source_vertex.size());
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    numbers[surface.source_vertex[vertex]] = vertex;
  return numbers;
}

}  // namespace burin
