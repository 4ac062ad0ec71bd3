#pragma once
#include <burin/stroke/pen.h>

#include <array>

namespace burin {

/// The monotone cubic between two samples of a value [Steffen, A simple method for monotonic interpolation in
/// one dimension, 1990]. It is continuously differentiable, stays between the two values and is level at
/// local extrema of the samples. Except there, its error is of third order in the sampling interval.
class MonotoneCubic {
 public:
  /// Lengths of three successive intervals of the parameter; 0 for a missing one.
  struct Intervals {
    double before = 0, within = 1, after = 0;
  };
  /// Takes the values at the four ends of the intervals, and ignores those of a missing interval.
  MonotoneCubic(const Intervals& intervals, double first, double from, double to, double last);

  /// The value at a share s, 0..1, of the middle interval.
  double at(double s) const;

 private:
  double from_ = 0, to_ = 0;
  double slope_from_ = 0, slope_to_ = 0;  ///< per unit of s
};

/// Monotone cubics of the fields of a pen. The tilt is interpolated as the direction of the pen's upper end,
/// and the twist the shorter way round.
class PenCubic {
 public:
  PenCubic(const MonotoneCubic::Intervals& intervals, const Pen& first, const Pen& from, const Pen& to,
           const Pen& last);

  Pen at(double s) const;

 private:
  using Pens = std::array<Pen, 4>;
  PenCubic(const MonotoneCubic::Intervals& intervals, const Pens& pens);

  Pen from_;
  bool tilts_;  ///< whether the tilt differs between the two samples
  MonotoneCubic pressure_, twist_;
  std::array<MonotoneCubic, 3> upper_;  ///< coordinates of the upper end
};

/// Interpolates time and pen between two samples of a stroke.
struct PenSpline {
  MonotoneCubic times;
  PenCubic pens;

  double time(double s) const { return times.at(s); }
  Pen pen(double s) const { return pens.at(s); }
};

}  // namespace burin
