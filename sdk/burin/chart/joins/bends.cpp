// Finds bends by sliding a window of a quarter radius along the stroke: a bend is a maximal stretch on which
// the tangent turns by more than window / radius within the window. Costs O(s log n) for n points of the
// curve and s = 32 length / radius steps.
#include <burin/chart/joins/bends.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Bends that turn by less than this, radians, are ignored: their join makes no visible difference.
constexpr double least_turn = 0.35;

/// Upper limit of the number of steps along the stroke.
constexpr double most_steps = 1e5;

}  // namespace

double StrokeBends::angle_at(double t) const {
  const double loops = closed_ ? std::floor(t / length_) : 0;
  const double place = t - loops * length_;
  const auto after = std::ranges::upper_bound(t_, place) - t_.begin();
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1)) - 1;
  const bool last = i + 1 == t_.size();
  if (last && !closed_) return angles_[i];
  const double end = last ? length_ : t_[i + 1], angle = last ? loop_angle_ : angles_[i + 1];
  const double share = end > t_[i] ? std::clamp((place - t_[i]) / (end - t_[i]), 0., 1.) : 0;
  return angles_[i] + share * (angle - angles_[i]) + loops * loop_angle_;
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

void StrokeBends::update(const SurfaceCurve& curve, const GeodesicCurvature& curvature, double radius) {
  closed_ = curve.closed;
  length_ = curve.length();
  loop_angle_ = curvature.loop_angle();
  bends_.clear();
  t_.clear();
  angles_.clear();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    t_.push_back(curve.points[i].t);
    angles_.push_back(curvature.turned(i));
  }
  if (!(length_ > 0)) return;

  const double window = radius / 4, step = std::max(radius / 32, length_ / most_steps);
  const auto sharpness = [&](double t) { return turn(t - window / 2, t + window / 2) / (window / radius); };
  const auto steps = static_cast<long>(std::ceil(length_ / step));
  // On a closed stroke a bend across the seam is found from where it begins, before the seam.
  for (long i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) * step, now = sharpness(t);
    if (std::abs(now) <= 1) continue;
    Bend bend{t - window / 2, 0, t + window / 2, 0};
    const bool entered = i > 0 || !closed_ || sharpness(-step) * now <= 0 || std::abs(sharpness(-step)) <= 1;
    while (i < 2 * steps && sharpness(static_cast<double>(i) * step) * now > std::abs(now)) ++i;
    bend.end = static_cast<double>(i - 1) * step + window / 2;
    bend.turn = turn(bend.begin, bend.end);
    if (!entered || std::abs(bend.turn) < least_turn) continue;
    const double margin = radius / 16, begin = reached(bend, 0.02) - margin,
                 end = reached(bend, 0.98) + margin;
    bend.middle = reached(bend, 0.5);
    bend.begin = begin;
    bend.end = end;
    bends_.push_back(bend);
  }
}

}  // namespace burin
