// Steffen's monotone cubic interpolation (1990): Hermite cubics whose slopes are those of a parabola through
// three samples, limited to twice the smaller secant slope and zero at local extrema. O(1) per segment.
#include <burin/stroke/curve/pen_spline.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The slope at the point between two intervals of these lengths and secant slopes.
double inner_slope(double before, double after, double secant_before, double secant_after) {
  if (secant_before * secant_after <= 0) return 0;
  const double parabola = (secant_before * after + secant_after * before) / (before + after);
  const double steepest = 2 * std::min(std::abs(secant_before), std::abs(secant_after));
  return std::copysign(std::min(std::abs(parabola), steepest), parabola);
}

/// The slope at the free end of an interval that has one neighbour.
double end_slope(double extent, double neighbour, double secant, double secant_neighbour) {
  const double share = extent / (extent + neighbour);
  const double parabola = secant * (1 + share) - secant_neighbour * share;
  if (parabola * secant <= 0) return 0;
  return std::copysign(std::min(std::abs(parabola), 2 * std::abs(secant)), secant);
}

MonotoneCubic cubic(const MonotoneCubic::Intervals& intervals, const std::array<double, 4>& values) {
  return {intervals, values[0], values[1], values[2], values[3]};
}

/// The twists plus or minus whole turns so that successive ones differ by at most half a turn.
std::array<double, 4> unwound_twists(const std::array<Pen, 4>& pens) {
  const double from = pens[1].twist, to = twist_near(pens[2].twist, from);
  return {twist_near(pens[0].twist, from), from, to, twist_near(pens[3].twist, to)};
}

std::array<MonotoneCubic, 3> upper_cubics(const MonotoneCubic::Intervals& intervals,
                                          const std::array<Pen, 4>& pens) {
  std::array<Vec3d, 4> ends;
  std::ranges::transform(pens, ends.begin(), upper_end);
  const auto along = [&](int axis) {
    return cubic(intervals, {ends[0][axis], ends[1][axis], ends[2][axis], ends[3][axis]});
  };
  return {along(0), along(1), along(2)};
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
  return std::clamp(value, std::min(from_, to_), std::max(from_, to_));  // against rounding errors
}

PenCubic::PenCubic(const MonotoneCubic::Intervals& intervals, const Pen& first, const Pen& from,
                   const Pen& to, const Pen& last)
    : PenCubic(intervals, {first, from, to, last}) {}

PenCubic::PenCubic(const MonotoneCubic::Intervals& intervals, const Pens& pens)
    : from_(pens[1]),
      tilts_(!same_tilt(pens[1], pens[2])),
      pressure_(cubic(intervals, {pens[0].pressure, pens[1].pressure, pens[2].pressure, pens[3].pressure})),
      twist_(cubic(intervals, unwound_twists(pens))),
      upper_(upper_cubics(intervals, pens)) {}

Pen PenCubic::at(double s) const {
  Pen pen = from_;
  pen.pressure = static_cast<float>(pressure_.at(s));
  pen.twist = wrap_twist(twist_.at(s));
  if (tilts_) set_upper_end(pen, {upper_[0].at(s), upper_[1].at(s), upper_[2].at(s)});
  return pen;
}

}  // namespace burin
