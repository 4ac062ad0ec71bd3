#pragma once
#include <burin/chart/path/closed_length.h>
#include <burin/stroke/curve/surface_curve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// How far the stroke's full width goes on straight beyond its ends, object units; 0: it ends in a round cap.
struct Extensions {
  double begin = 0, end = 0;
  bool operator==(const Extensions&) const = default;
};

/// Evenly spaced points of a stroke by which its visits to a vertex are told apart: discs of 1.25 times the
/// stroke's half width around them, an eighth of its radius apart [Schmidt 2013, section 4.1: "slide a
/// geodesic disc along S"].
class StrokeSamples {
 public:
  /// Takes the samples of another curve, of at least one point, no finer than `finest`. Discs near the ends
  /// are wide enough for the extensions. The first `unchanged` points are those of the curve before, and
  /// radius and extensions are as before, or the samples were cleared. Returns the first that differs.
  Index update(const SurfaceCurve& curve, double radius, double finest, const Extensions& extensions,
               std::size_t unchanged);
  void clear() { samples_.clear(); }

  Index size() const { return static_cast<Index>(samples_.size()); }
  double length() const { return length_; }
  bool closed() const { return closed_; }

  /// The sample nearest to the arc length t; beyond the ends of an open stroke the last one there.
  Index at(double t) const {
    if (closed_) return at_of_closed(t);
    const Index last = size() - 1;
    if (!(t < length_)) return last;
    const double half_a_step_on = t * samples_a_unit_ + 0.5;
    return t > 0 ? std::min(static_cast<Index>(half_a_step_on), last) : 0;
  }

  /// Arc length of a sample.
  double t(Index sample) const { return samples_[sample].t; }

  /// Arc lengths of a closed stroke brought to [0, length), and to within half a length of another. Those of
  /// an open one as they are.
  double wrapped(double t) const { return closed_ ? wrapped_t(t, length_) : t; }
  double unwrapped(double t, double near) const { return closed_ ? t_nearest_to(near, t, length_) : t; }

  /// Half width of the stroke at the arc length t, object units.
  double half_width(double t) const { return uniform_ ? uniform_half_width_ : varying_half_width(t); }

  /// Whether the disc around the sample holds a point with this normal. Its geodesic distance is taken for
  /// the length of a circular arc over the chord, at whose ends the two normals stand.
  bool disc_holds(Index sample, const Vec3f& position, const Vec3f& normal) const {
    const Sample& s = samples_[sample];
    return (position - s.position).squaredNorm() * squared_arc_over_chord(normal.dot(s.normal)) <=
           s.disc * s.disc;
  }

  /// Radius of the disc around the sample, object units.
  float disc(Index sample) const { return samples_[sample].disc; }

  /// Whether the stroke bends there so sharply that places in its disc may be nearer to the samples before
  /// and after. Where it does not, a stroke that goes away from a vertex goes on to do so.
  bool may_turn(Index sample) const { return may_turn_[sample] != 0; }

  /// How many samples after `from` the sample comes; on an open stroke more than there are when it comes
  /// before.
  Index steps(Index from, Index sample) const {
    return sample >= from || !closed_ ? sample - from : sample + size() - from;
  }

  /// Straight distance, object units.
  float chord(Index sample, const Vec3f& position) const {
    return (position - samples_[sample].position).norm();
  }

 private:
  struct Sample {
    double t;
    Vec3f position, normal;
    float half_width;
    float disc;  ///< its radius
    bool operator==(const Sample&) const = default;
  };
  /// Arc over chord, squared, of a circular arc whose normals have this cosine: (asin s / s)^2, s the sine of
  /// half the angle. A polynomial within 4 %.
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
  double length_ = 0, spacing_ = 0, samples_a_unit_ = 0;
  bool closed_ = false;
  bool uniform_ = false;  ///< all half widths are one
  double uniform_half_width_ = 0;
};

}  // namespace burin
