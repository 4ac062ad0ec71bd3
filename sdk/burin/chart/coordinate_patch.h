#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>
#include <burin/surface/base_patch.h>

#include <array>

namespace burin {

/// t and d around a node of a base surface's chart, from its frame: the quadratics over the node's BasePatch
/// that agree to second order with the Fermi coordinates of the stroke, where J hardly varies along it. A
/// step of u along e1 and v along e2 adds u / J (1 + k v) to t and v - k u^2 / 2 to d.
class CoordinatePatch {
 public:
  /// Points are taken several at a time.
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;
  struct Vectors {
    Lanes x, y, z;
    Vec3f operator[](int lane) const { return {x[lane], y[lane], z[lane]}; }
  };

  /// The frames at the feet of points on the patch.
  struct Frames {
    Lanes t;  ///< beyond the node's
    Lanes d, stretch;
    Vectors e1, normal;
    Lanes certain;  ///< 1, or 0 where lines of the stroke meet and e1 is to be the node's own

    /// Of one point. Curvature is not told.
    ChartFrame frame(int lane, const ChartFrame& node) const;
  };

  CoordinatePatch(const BasePatch& patch, const ChartFrame& frame);

  Frames at(const Vectors& points) const;

 private:
  using Local = BasePatch::Local<Lanes>;
  struct Quadratic {
    float x, y, xx, xy, yy;  ///< first and second derivatives
    Lanes value(const Local& at) const;
    Local slope(const Local& at) const;
  };
  Vectors in_space(const Lanes& x, const Lanes& y, const Lanes& z) const;

  BasePatch patch_;
  Vec3f axis_y_;
  float d_;  ///< of the node
  Quadratic t_terms_, d_terms_;
};

}  // namespace burin
