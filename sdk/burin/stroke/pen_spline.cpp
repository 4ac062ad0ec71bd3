#include <burin/stroke/pen_spline.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Slope between two intervals of these extents and secants.
double inner_slope(double before, double after, double secant_before, double secant_after) {
  if (secant_before * secant_after <= 0) return 0;
  const double parabola = (secant_before * after + secant_after * before) / (before + after);
  const double steepest = 2 * std::min(std::abs(secant_before), std::abs(secant_after));
  return std::copysign(std::min(std::abs(parabola), steepest), parabola);
}

/// Slope at the free end of an interval that has one neighbour.
double end_slope(double extent, double neighbour, double secant, double secant_neighbour) {
  const double share = extent / (extent + neighbour);
  const double parabola = secant * (1 + share) - secant_neighbour * share;
  if (parabola * secant <= 0) return 0;
  return std::copysign(std::min(std::abs(parabola), 2 * std::abs(secant)), secant);
}

}  // namespace

MonotoneCubic::MonotoneCubic(const Intervals& intervals, double first, double from, double to, double last)
    : from_(from), to_(to) {
  const auto& [before, within, after] = intervals;
  const double secant = (to - from) / within;
  const double secant_before = before > 0 ? (from - first) / before : 0;
  const double secant_after = after > 0 ? (last - to) / after : 0;
  slope_from_ = slope_to_ = secant;
  if (before > 0)
    slope_from_ = inner_slope(before, within, secant_before, secant);
  else if (after > 0)
    slope_from_ = end_slope(within, after, secant, secant_after);
  if (after > 0)
    slope_to_ = inner_slope(within, after, secant, secant_after);
  else if (before > 0)
    slope_to_ = end_slope(within, before, secant, secant_before);
  slope_from_ *= within;
  slope_to_ *= within;
}

double MonotoneCubic::at(double s) const {
  const double s2 = s * s, s3 = s2 * s;
  const double value =
      from_ + (3 * s2 - 2 * s3) * (to_ - from_) + (s3 - 2 * s2 + s) * slope_from_ + (s3 - s2) * slope_to_;
  return std::clamp(value, std::min(from_, to_), std::max(from_, to_));  // but for rounding within already
}

PenCubic::PenCubic(const MonotoneCubic::Intervals& intervals, const Pen& first, const Pen& from,
                   const Pen& to, const Pen& last)
    : pressure_(intervals, first.pressure, from.pressure, to.pressure, last.pressure),
      tilt_x_(intervals, first.tilt_x, from.tilt_x, to.tilt_x, last.tilt_x),
      tilt_y_(intervals, first.tilt_y, from.tilt_y, to.tilt_y, last.tilt_y),
      twist_(intervals, first.twist, from.twist, to.twist, last.twist) {}

Pen PenCubic::at(double s) const {
  const auto value = [s](const MonotoneCubic& cubic) { return static_cast<float>(cubic.at(s)); };
  return {value(pressure_), value(tilt_x_), value(tilt_y_), value(twist_)};
}

}  // namespace burin
