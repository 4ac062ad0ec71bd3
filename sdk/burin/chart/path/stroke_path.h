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

/// Evenly spaced places of a stroke, by which coordinates are held against the stroke itself: no way on a
/// surface is shorter than the straight line.
class StrokePath {
 public:
  /// Takes the places of another curve, of at least one point, and of this curvature; 1/64 of the radius
  /// apart but no finer than `finest`, object units. The first `unchanged` points and their curvatures are
  /// those before, and so are radius and extensions, or the path was cleared.
  void update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius, double finest,
              std::size_t unchanged, const Extensions& extensions = {});
  void clear() { places_.clear(); }

  bool closed() const { return closed_; }
  double length() const { return length_; }

  /// Geodesic curvature of the stroke at t, or at its end; 1 / length.
  float curvature(double t) const {
    const auto [from, to, s] = around(t);
    return from->curvature + s * (to->curvature - from->curvature);
  }

  /// How far beyond the ends of an open stroke t lies, object units, >= 0.
  double beyond(double t) const { return beyond_ends(t, length_, closed_); }

  /// Whether the stroke ends in a round cap there, and does not go on straight.
  bool round_begin() const { return round_begin_; }
  bool round_end() const { return round_end_; }

  /// On which the distance of the coordinates (t, d) is told.
  DistanceRay ray(double t, double d) const {
    if ((t >= 0 && t <= length_) || closed_ || !(t < 0 ? round_begin_ : round_end_)) return {};
    const double past = t < 0 ? t : t - length_, length = std::sqrt(past * past + d * d);
    // Coordinates that are no numbers have no ray either.
    if (!(length > std::numeric_limits<float>::min())) return {};
    const double inverse = 1 / length;
    return {static_cast<float>(past * inverse), static_cast<float>(d * inverse), static_cast<float>(length),
            static_cast<float>(inverse)};
  }

  /// The distance from the stroke that the coordinates (t, d) tell: |d|, and beyond the ends that to the end.
  double told_distance(double t, double d) const {
    const double past = beyond(t);
    return past > 0 ? std::sqrt(past * past + d * d) : std::abs(d);
  }

  /// By how much the straight line from x to the stroke at t, or to its end, is longer than the distance that
  /// is told by (t, d); 0 where it is not, or less than the doubt. Otherwise the coordinates are false.
  double excess(double t, double d, const Vec3f& x) const {
    const double told = told_distance(t, d), allowed = told + doubt_;
    const auto squared = static_cast<double>((x - position(t)).squaredNorm());
    return squared > allowed * allowed ? std::sqrt(squared) - told : 0;
  }

  /// The distance that (t, d) tell, but no less than that straight line allows.
  double distance(double t, double d, const Vec3f& x) const {
    const double more = excess(t, d, x);
    return told_distance(t, d) + (more > 0 ? more - doubt_ : 0);
  }

  /// Up to which the places stray from the curve, where it bends four times as sharply as its radius, and
  /// second-order frames from the truth.
  double doubt() const { return doubt_; }

 private:
  struct Place {
    Vec3f position;
    float curvature;
  };
  /// Two places, and how far t is on the way from the one to the other.
  struct Around {
    const Place *from, *to;
    float s;
  };
  Around around(double t) const {
    const double place = std::clamp(closed_ ? wrapped_t(t, length_) : t, 0., length_) * places_a_unit_;
    // Coordinates that are no numbers count as those of the begin.
    const std::size_t from = place > 0 ? static_cast<std::size_t>(place) : 0;
    return {&places_[from], &places_[from + 1], static_cast<float>(place - static_cast<double>(from))};
  }
  Vec3f position(double t) const {
    const auto [from, to, s] = around(t);
    return from->position + s * (to->position - from->position);
  }

  std::vector<Place> places_;  ///< [i] at i times the spacing, and straight on beyond the end
  double length_ = 0, spacing_ = 0, places_a_unit_ = 0, doubt_ = 0;
  bool closed_ = false, round_begin_ = false, round_end_ = false;
};

}  // namespace burin
