#pragma once
#include <burin/host/c/burin.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin::c {

/// The numbers that a caller of C has for the vertices of a surface.
class VertexOrder {
 public:
  /// The surface must outlive the object. 4 bytes per vertex in the caller's order.
  VertexOrder(const Surface& surface, burin_order order) : surface_(&surface) {
    if (order != BURIN_ORDER_SURFACE) to_surface_ = inverse(surface);
  }

  Index to_surface(Index number) const { return to_surface_.empty() ? number : to_surface_[number]; }
  Index of_surface(Index vertex) const {
    return to_surface_.empty() ? vertex : surface_->source_vertex[vertex];
  }

  /// [vertex of the mesh that the surface was made of] its number on the surface.
  static std::vector<Index> inverse(const Surface& surface) {
    std::vector<Index> numbers(surface.source_vertex.size());
    for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
      numbers[surface.source_vertex[vertex]] = vertex;
    return numbers;
  }

 private:
  const Surface* surface_;
  std::vector<Index> to_surface_;  ///< empty: the numbers are the surface's
};

}  // namespace burin::c
