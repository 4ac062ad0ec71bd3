#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/base_surface.h>

#include <array>

namespace burin {

/// t and d around a node of a base surface's chart, from its frame: the quadratics over the node's BasePatch
/// that agree to second order with the Fermi coordinates of the stroke, where J hardly varies along it. A
/// step of u along e1 and v along e2 adds u / J (1 + k v) to t and v - k u^2 / 2 to d.
class CoordinatePatch {
 public:
  CoordinatePatch(const BasePatch& patch, const ChartFrame& frame);

  /// At a place of the patch. Curvature is not told.
  ChartFrame frame_at(const BasePatch& patch, const Vec2f& at) const;

 private:
  double t_;  ///< of the node
  float d_;
  Vec3f e1_;
  std::array<float, 6> t_terms_{}, d_terms_{};  ///< value, x, y, xx / 2, xy, yy / 2; beyond t_ and d_
};

}  // namespace burin
