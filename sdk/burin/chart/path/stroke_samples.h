#pragma once
#include <burin/chart/path/closed_length.h>
#include <burin/stroke/curve/surface_curve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// How far the stroke continues straight, at full width, beyond its ends, object units; 0 means a round cap.
struct Extensions {
  double begin = 0, end = 0;
  bool operator==(const Extensions&) const = default;
};

/// Radius of a sample's disc, in half widths of the stroke there.
inline constexpr double disc_over_width = 1.25;

/// Evenly spaced points of a stroke that distinguish its visits to a vertex. Each sample has a disc, and
/// samples are an eighth of the radius apart [Schmidt 2013, section 4.1: "slide a geodesic disc along S"].
class StrokeSamples {
 public:
  /// The largest distance between samples of a stroke of this radius, object units, unless update() is given
  /// a larger `finest`.
  static constexpr double most_spacing(double radius) { return radius / 8; }

  /// Samples another curve, of at least one point, at a spacing of at least `finest`, object units. Discs
  /// near the ends are large enough for the extensions. Unless the samples were cleared, the first
  /// `unchanged` points, the radius and the extensions must be as before. Returns the first sample that
  /// differs.
  Index update(const SurfaceCurve& curve, double radius, double finest, const Extensions& extensions,
               std::size_t unchanged);
  void clear() { samples_.clear(); }

  Index size() const { return static_cast<Index>(samples_.size()); }
  double length() const { return length_; }
  bool closed() const { return closed_; }

  /// The sample nearest to the arc length t, clamped to the ends of an open stroke.
  Index at(double t) const {
    if (closed_) return at_of_closed(t);
    const Index last = size() - 1;
    if (!(t < length_)) return last;
    const double half_a_step_on = t * samples_per_unit_ + 0.5;
    return t > 0 ? std::min(static_cast<Index>(half_a_step_on), last) : 0;
  }

  /// Arc length of a sample.
  double t(Index sample) const { return samples_[sample].t; }

  /// Reduce an arc length of a closed stroke to [0, length), and to within half a length of `near`. On an
  /// open stroke the arc length stays as it is.
  double wrapped(double t) const { return closed_ ? wrapped_t(t, length_) : t; }
  double unwrapped(double t, double near) const { return closed_ ? t_nearest_to(near, t, length_) : t; }

  /// Half width of the stroke at the arc length t, object units.
  double half_width(double t) const { return uniform_ ? uniform_half_width_ : varying_half_width(t); }

  /// Whether the disc around the sample holds a point with this unit normal. The geodesic distance is
  /// estimated as the length of the circular arc between the two points that has the two normals at its ends.
  bool disc_holds(Index sample, const Vec3f& position, const Vec3f& normal) const {
    const Sample& s = samples_[sample];
    return (position - s.position).squaredNorm() * squared_arc_over_chord(normal.dot(s.normal)) <=
           s.disc * s.disc;
  }

  /// Radius of the disc around the sample, object units.
  float disc(Index sample) const { return samples_[sample].disc; }

  /// Whether the stroke bends so sharply at the sample that a point in its disc may be nearer to both
  /// neighbouring samples. Otherwise a stroke that moves away from a vertex at this sample continues to do so
  /// at the next.
  bool may_turn(Index sample) const { return may_turn_[sample] != 0; }

  /// The number of steps from one sample forward to another. On an open stroke it exceeds the number of
  /// samples (by unsigned wrap-around) when the other comes first.
  Index steps(Index from, Index sample) const {
    return sample >= from || !closed_ ? sample - from : sample + size() - from;
  }

  /// Straight distance from the sample to a position, object units.
  float chord(Index sample, const Vec3f& position) const {
    return (position - samples_[sample].position).norm();
  }

 private:
  struct Sample {
    double t;
    Vec3f position, normal;
    float half_width;
    float disc;  ///< radius of its disc, object units
    bool operator==(const Sample&) const = default;
  };
  /// The squared ratio of arc to chord for a circular arc whose end normals enclose an angle with this
  /// cosine: (asin s / s)^2, where s is the sine of half the angle. A polynomial approximates it within 4 %.
  static float squared_arc_over_chord(float cosine) {
    const float s2 = std::clamp((1 - cosine) / 2, 0.F, 1.F), s4 = s2 * s2;
    const float ratio = 1 + s2 / 6 + 0.075F * s4 + 0.329F * s4 * s4 * s2;
    return ratio * ratio;
  }
  Index at_of_closed(double t) const;
  double varying_half_width(double t) const;

  void find_turns(Index from);

  std::vector<Sample> samples_;
  std::vector<std::uint8_t> may_turn_;  ///< [sample]
  double length_ = 0, spacing_ = 0, samples_per_unit_ = 0;
  bool closed_ = false;
  bool uniform_ = false;  ///< all half widths are equal
  double uniform_half_width_ = 0;
};

}  // namespace burin
