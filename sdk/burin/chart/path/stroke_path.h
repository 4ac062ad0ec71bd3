#pragma once
#include <burin/base/vector.h>
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/distance_ray.h>
#include <burin/chart/path/stroke_samples.h>
#include <burin/stroke/curve/geodesic_curvature.h>
#include <burin/stroke/curve/surface_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace burin {

/// Evenly spaced points of a stroke, against which coordinates are checked: no path on a surface is shorter
/// than the straight line, so a distance below it is wrong. Queries cost O(1).
class StrokePath {
 public:
  /// Samples another curve, of at least one point, and its curvature, at a spacing of 1/64 of the radius but
  /// at least `finest`, object units. Unless the path was cleared, the first `unchanged` points and their
  /// curvatures, the radius and the extensions must be as before.
  void update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius, double finest,
              std::size_t unchanged, const Extensions& extensions = {});
  void clear() { points_.clear(); }

  bool closed() const { return closed_; }
  double length() const { return length_; }
  double spacing() const { return spacing_; }  ///< what is told of t depends on no more beyond it

  /// Geodesic curvature of the stroke at t, clamped to its ends; 1 / length, left positive.
  float curvature(double t) const {
    const auto [from, to, s] = around(t);
    return from->curvature + s * (to->curvature - from->curvature);
  }

  /// The distance of t beyond the ends of an open stroke, object units, >= 0.
  double beyond(double t) const { return beyond_ends(t, length_, closed_); }

  /// Whether the stroke has a round cap there rather than a straight extension.
  bool round_begin() const { return round_begin_; }
  bool round_end() const { return round_end_; }

  /// The distance ray at the coordinates (t, d).
  DistanceRay ray(double t, double d) const {
    if ((t >= 0 && t <= length_) || closed_ || !(t < 0 ? round_begin_ : round_end_)) return {};
    const double past = t < 0 ? t : t - length_, length = std::sqrt(past * past + d * d);
    // Coordinates that are not numbers have no ray from the end either.
    if (!(length > std::numeric_limits<float>::min())) return {};
    const double inverse = 1 / length;
    return {static_cast<float>(past * inverse), static_cast<float>(d * inverse), static_cast<float>(length),
            static_cast<float>(inverse)};
  }

  /// The distance from the stroke according to the coordinates (t, d): |d| beside the stroke, the distance
  /// from the end beyond it.
  double chart_distance(double t, double d) const {
    const double past = beyond(t);
    return past > 0 ? std::sqrt(past * past + d * d) : std::abs(d);
  }

  /// By how much the straight line from x to the stroke at t, clamped to its ends, is longer than the
  /// distance according to (t, d). It is 0 when it is at most the tolerance doubt(); otherwise the
  /// coordinates are wrong.
  double excess(double t, double d, const Vec3f& x) const {
    const double told = chart_distance(t, d), allowed = told + doubt_;
    const auto squared = static_cast<double>((x - position(t)).squaredNorm());
    return squared > allowed * allowed ? std::sqrt(squared) - told : 0;
  }

  /// The distance according to (t, d), or the length of that straight line, less the tolerance, if it is
  /// longer.
  double distance(double t, double d, const Vec3f& x) const {
    const double more = excess(t, d, x);
    return chart_distance(t, d) + (more > 0 ? more - doubt_ : 0);
  }

  /// The tolerance, object units. It covers the distance of the sampled points from a curve that bends four
  /// times as sharply as its radius, and the error of second-order frames.
  double doubt() const { return doubt_; }

 private:
  struct Point {
    Vec3f position;
    float curvature;
  };
  /// Two neighbouring points, and the share of the way between them at which t lies.
  struct Around {
    const Point *from, *to;
    float s;
  };
  Around around(double t) const {
    const double at = std::clamp(closed_ ? wrapped_t(t, length_) : t, 0., length_) * points_per_unit_;
    // Coordinates that are not numbers count as the start.
    const std::size_t from = at > 0 ? static_cast<std::size_t>(at) : 0;
    return {&points_[from], &points_[from + 1], static_cast<float>(at - static_cast<double>(from))};
  }
  Vec3f position(double t) const {
    const auto [from, to, s] = around(t);
    return from->position + s * (to->position - from->position);
  }

  std::vector<Point>
      points_;  ///< [i] at i times the spacing; the last one lies on a straight line past the end
  double length_ = 0, spacing_ = 0, points_per_unit_ = 0, doubt_ = 0;
  bool closed_ = false, round_begin_ = false, round_end_ = false;
};

}  // namespace burin
