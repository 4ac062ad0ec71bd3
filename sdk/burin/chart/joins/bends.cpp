// Finds bends by sliding a window of a quarter radius along the stroke: a bend is a maximal stretch on which
// the tangent turns by more than window / radius within the window. Costs O(s log n) for n points of the
// curve and s = 32 length / radius steps; when the curve grows, only the steps near what changed are taken
// again.
#include <burin/chart/joins/bends.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Bends that turn by less than this, radians, are ignored: their join makes no visible difference.
constexpr double least_turn = 0.35;

/// Upper limit of the number of steps along the stroke.
constexpr double most_steps = 1e5;

/// The width of the window, and the length of a step, in radii.
constexpr double window_width = 0.25, step_length = 1. / 32;

}  // namespace

double StrokeBends::angle_at(double t) const {
  const double loops = closed_ ? std::floor(t / length_) : 0;
  const double place = t - loops * length_;
  const auto after = std::ranges::upper_bound(t_, place) - t_.begin();
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1)) - 1;
  const bool last = i + 1 == t_.size();
  if (last && !closed_) return angles_.at(i);
  const double end = last ? length_ : t_[i + 1], angle = last ? angles_.loop() : angles_.at(i + 1);
  const double share = end > t_[i] ? std::clamp((place - t_[i]) / (end - t_[i]), 0., 1.) : 0;
  return angles_.at(i) + share * (angle - angles_.at(i)) + loops * angles_.loop();
}

/// Finds by bisection the arc length at which this share of the bend's turn is complete.
double StrokeBends::reached(const Bend& bend, double share) const {
  double low = bend.begin, high = bend.end;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (turn(bend.begin, middle) / bend.turn < share ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The turn within the window around a step over that of a circle of the radius.
double StrokeBends::sharpness(long step) const {
  const double t = static_cast<double>(step) * step_;
  return turn(t - window_ / 2, t + window_ / 2) / window_width;
}

/// The bend on a stretch that holds all of its turn, with some margin on either side.
Bend StrokeBends::measured(double begin, double end) const {
  const Bend stretch{begin, 0, end, turn(begin, end)};
  const double margin = window_ / 4;
  return {reached(stretch, 0.02) - margin, reached(stretch, 0.5), reached(stretch, 0.98) + margin,
          stretch.turn};
}

void StrokeBends::update(const SurfaceCurve& curve, double radius, std::size_t unchanged) {
  if (curve.closed || closed_) unchanged = 0;
  closed_ = curve.closed;
  length_ = curve.length();
  angles_.update(curve, unchanged);
  t_.resize(unchanged);
  for (std::size_t i = unchanged; i < curve.points.size(); ++i) t_.push_back(curve.points[i].t);
  const double step = std::max(radius * step_length, length_ / most_steps);
  if (step != step_) unchanged = 0;
  step_ = step;
  window_ = radius * window_width;
  const long from = unchanged > 0 ? drop_changed(t_[unchanged - 1]) : 0;
  if (from == 0) {
    bends_.clear();
    ends_.clear();
  }
  if (length_ > 0) find(from);
}

/// Drops the bends that depend on the curve beyond this arc length. Returns a step within no bend, up to
/// which all bends are kept.
long StrokeBends::drop_changed(double unchanged_t) {
  long from = static_cast<long>((unchanged_t - window_ / 2) / step_) - 1;
  while (from > 0 && std::abs(sharpness(from)) > 1) --from;
  from = std::max(from, 0L);
  while (!ends_.empty() && ends_.back() > from) {
    bends_.pop_back();
    ends_.pop_back();
  }
  return from;
}

void StrokeBends::find(long from) {
  const auto steps = static_cast<long>(std::ceil(length_ / step_));
  // On a closed stroke a bend across the seam is found from where it begins, before the seam.
  for (long i = from; i < steps; ++i) {
    const double now = sharpness(i);
    if (std::abs(now) <= 1) continue;
    const bool entered = i > 0 || !closed_ || sharpness(-1) * now <= 0 || std::abs(sharpness(-1)) <= 1;
    const double begin = static_cast<double>(i) * step_ - window_ / 2;
    while (i < 2 * steps && sharpness(i) * now > std::abs(now)) ++i;
    const double end = static_cast<double>(i - 1) * step_ + window_ / 2;
    if (!entered || std::abs(turn(begin, end)) < least_turn) continue;
    bends_.push_back(measured(begin, end));
    ends_.push_back(i);
  }
}

}  // namespace burin
