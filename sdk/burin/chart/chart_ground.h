#pragma once
#include <burin/surface/base_surface/base_surface.h>

#include <span>

namespace burin {

/// The geometry of one vertex of the ground, as a front reads it.
struct GroundVertex {
  Vec3f position;
  Vec3f normal;               ///< unit
  float gauss_curvature = 0;  ///< 1 / length^2
};

/// The graph that a front spreads over: the vertices of a surface, or the nodes of a base surface, whose
/// patches are computed when they are first read. Non-owning.
class ChartGround {
 public:
  explicit ChartGround(const Surface& surface)
      : surface_(&surface), neighbours_(&surface.neighbours), scale_(surface.scale) {}
  explicit ChartGround(BaseSurface& base)
      : base_(&base), neighbours_(&base.neighbours()), scale_(base.scale()) {}

  Index vertex_count() const { return neighbours_->rows(); }
  double scale() const { return scale_; }  ///< see Surface::scale
  std::span<const Index> neighbours(Index vertex) const { return (*neighbours_)[vertex]; }

  GroundVertex operator[](Index vertex) const {
    if (!base_)
      return {surface_->positions[vertex], surface_->normals[vertex], surface_->gauss_curvature[vertex]};
    const BasePatch& patch = base_->patch(vertex);
    return {patch.position, patch.normal, patch.gauss_curvature()};
  }

  /// The surface whose vertices these are; null for the nodes of a base surface.
  const Surface* surface() const { return surface_; }

  /// Whether several threads may read at once.
  bool concurrent() const { return !base_; }

 private:
  const Surface* surface_ = nullptr;
  BaseSurface* base_ = nullptr;
  const Csr* neighbours_;
  double scale_;
};

}  // namespace burin
