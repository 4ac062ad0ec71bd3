#pragma once
#include <burin/stroke/pen.h>

#include <array>

namespace burin {

/// The monotone cubic between two samples of a value [Steffen, A simple method for monotonic interpolation in
/// one dimension, 1990]: smooth, never beyond the two, and level where the value turns. So a pen sampled
/// seldom is the pen sampled often, to third order.
class MonotoneCubic {
 public:
  /// Extents of three successive intervals of the parameter; 0 for one that is missing.
  struct Intervals {
    double before = 0, within = 1, after = 0;
  };
  /// Values at the four ends of the intervals. Those of a missing one are not looked at.
  MonotoneCubic(const Intervals& intervals, double first, double from, double to, double last);

  /// At a share of the interval in the middle, 0..1.
  double at(double s) const;

 private:
  double from_, to_;
  double slope_from_, slope_to_;  ///< a unit of s
};

/// The same of the pen. Its tilt is the direction of its upper end, and its twist goes the shorter way round.
class PenCubic {
 public:
  PenCubic(const MonotoneCubic::Intervals& intervals, const Pen& first, const Pen& from, const Pen& to,
           const Pen& last);

  Pen at(double s) const;

 private:
  using Pens = std::array<Pen, 4>;
  PenCubic(const MonotoneCubic::Intervals& intervals, const Pens& pens);

  Pen from_;
  bool tilts_;  ///< from one sample to the other
  MonotoneCubic pressure_, twist_;
  std::array<MonotoneCubic, 3> upper_;  ///< coordinates of the upper end
};

/// Time and pen between two samples of a stroke.
struct PenSpline {
  MonotoneCubic times;
  PenCubic pens;

  double time(double s) const { return times.at(s); }
  Pen pen(double s) const { return pens.at(s); }
};

}  // namespace burin
