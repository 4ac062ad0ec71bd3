#pragma once
#include <burin/surface/base_surface.h>

namespace burin {

/// What a front spreads over: the vertices of a surface, or the nodes of a base surface, which are made when
/// the front comes by. Looked at, not owned.
class ChartGround {
 public:
  explicit ChartGround(const Surface& surface) : surface_(&surface) {}
  explicit ChartGround(BaseSurface& base) : surface_(&base.nodes()), base_(&base) {}

  Index vertex_count() const { return surface_->vertex_count(); }
  double scale() const { return surface_->scale; }
  std::span<const Index> neighbours(Index vertex) const { return surface_->neighbours[vertex]; }

  /// Place, normal and curvature of a vertex may be read after this.
  void require(Index vertex) const {
    if (base_) base_->require(vertex);
  }
  const Surface& surface() const { return *surface_; }

  /// Whether several threads may ask at once.
  bool concurrent() const { return !base_; }

 private:
  const Surface* surface_;
  BaseSurface* base_ = nullptr;
};

}  // namespace burin
