#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/base_surface.h>

#include <array>
#include <span>

namespace burin {

/// t and d around a node of a base surface's chart: quadratics over the node's BasePatch.
class CoordinatePatch {
 public:
  /// What a node of the chart says of the place where it stands.
  struct Told {
    Vec3f position;  ///< object units
    double t;
    float d;
  };

  /// The least-squares quadratics through what the nodes around tell, each counting less the farther away it
  /// is, up to `reach`, object units. Too few of them leave what the frame of the node itself says.
  CoordinatePatch(const BasePatch& patch, const ChartFrame& frame, std::span<const Told> around,
                  double reach);

  /// At a place of the patch. Curvature is not told.
  ChartFrame frame_at(const BasePatch& patch, const Vec2f& at) const;

 private:
  double t_;  ///< of the node
  float d_;
  Vec3f e1_;
  std::array<float, 6> t_terms_{}, d_terms_{};  ///< value, x, y, xx / 2, xy, yy / 2; beyond t_ and d_
};

}  // namespace burin
