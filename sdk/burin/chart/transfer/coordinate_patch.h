#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/path/distance_ray.h>
#include <burin/surface/base_surface/base_patch.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace burin {

/// Extrapolates t and d around a node of a base surface's chart from the node's frame. The two quadratics
/// over the node's BasePatch agree to second order with the Fermi coordinates of the stroke, provided that J
/// hardly varies along it. A step of u along e1 and v along e2 adds u / J (1 + k v) to t and v - k u^2 / 2 to
/// d; beyond round ends it adds what ray_step() computes.
class CoordinatePatch {
 public:
  /// Number of points evaluated at a time.
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;

  /// Points on the patch, in its local coordinates.
  using Feet = BasePatch::Local<Lanes>;

  /// The frames at the points.
  struct Frames {
    Lanes t;  ///< difference from the node's t
    Lanes d, stretch;
    Lanes e1_x, e1_y, e1_z;
    Lanes certain;  ///< 1, or 0 where |grad d| is too small and e1 is to be the node's own
  };

  /// `ray`: the distance ray at the frame.
  CoordinatePatch(const BasePatch& patch, const ChartFrame& frame, const DistanceRay& ray = {});

  Frames at(const Feet& feet) const;

  /// The frame of one lane. Its curvature is left at 0.
  ChartFrame frame(const Frames& frames, const Feet& feet, int lane) const;

  /// Calls visit(i, frame) for each of these points, in order.
  template <class Visit>
  void for_each_frame(std::span<const BasePatch::Local<float>> points, const Visit& visit) const;

 private:
  struct Quadratic {
    float x, y, xx, xy, yy;  ///< first and second derivatives
    Lanes value(const Feet& at) const;
    Feet slope(const Feet& at) const;
  };
  static Quadratic sum(float a, const Quadratic& of_a, float b, const Quadratic& of_b);
  Lanes component(int i, const Lanes& x, const Lanes& y, const Lanes& z) const;

  BasePatch patch_;
  Vec3f axis_y_;
  ChartFrame of_node_;
  Quadratic t_terms_, d_terms_;
};

inline ChartFrame CoordinatePatch::frame(const Frames& frames, const Feet& feet, int lane) const {
  ChartFrame frame;
  frame.t = of_node_.t + static_cast<double>(frames.t[lane]);
  frame.d = frames.d[lane];
  frame.e1 = {frames.e1_x[lane], frames.e1_y[lane], frames.e1_z[lane]};
  frame.stretch = frames.stretch[lane];
  if (!(frames.certain[lane] > 0))
    frame.e1 =
        unit_tangent(of_node_.e1, patch_.normal_at(BasePatch::Local<float>{feet.x[lane], feet.y[lane]}));
  return frame;
}

template <class Visit>
void CoordinatePatch::for_each_frame(std::span<const BasePatch::Local<float>> points,
                                     const Visit& visit) const {
  Feet feet{Lanes::Zero(), Lanes::Zero()};
  for (std::size_t begin = 0; begin < points.size(); begin += lanes) {
    const auto count = static_cast<int>(std::min<std::size_t>(lanes, points.size() - begin));
    for (int lane = 0; lane < count; ++lane) {
      feet.x[lane] = points[begin + static_cast<std::size_t>(lane)].x;
      feet.y[lane] = points[begin + static_cast<std::size_t>(lane)].y;
    }
    const Frames frames = at(feet);
    for (int lane = 0; lane < count; ++lane)
      visit(begin + static_cast<std::size_t>(lane), frame(frames, feet, lane));
  }
}

}  // namespace burin
