#pragma once
#include <burin/host/c/burin.h>
#include <burin/surface/source_numbers.h>

#include <vector>

namespace burin::c {

/// The numbers that a caller of C has for the vertices of a surface.
class VertexOrder {
 public:
  /// The surface must outlive the object. 4 bytes per vertex in the caller's order.
  VertexOrder(const Surface& surface, burin_order order) : surface_(&surface) {
    if (order != BURIN_ORDER_SURFACE) to_surface_ = numbers_of_source(surface);
  }

  Index to_surface(Index number) const { return to_surface_.empty() ? number : to_surface_[number]; }
  Index of_surface(Index vertex) const {
    return to_surface_.empty() ? vertex : surface_->source_vertex[vertex];
  }

 private:
  const Surface* surface_;
  std::vector<Index> to_surface_;  ///< empty: the numbers are the surface's
};

}  // namespace burin::c
