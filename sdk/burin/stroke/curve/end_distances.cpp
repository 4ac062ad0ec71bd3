// The distance of a position x from the stroke's ends along the stroke c, which tapered ends depend on. For a
// point of the stroke it is e(s), the smaller one of s and length - s. Where the stroke bends less sharply
// than its radius near an end, that of the nearest point f is taken. Elsewhere f may change from one part of
// a bend to another, and the distance is
//
//   E(x) = max(e(f), sup over s of  e(s) - K (max(D(s), far(s) - turn) - m) - P(|s - f|))
//   P(a) = max(0, a - K (sqrt(m^2 + a^2) - m))
//
// with D(s) = |x - c(s)|, m as the least D, and far(s) as the greatest D between f and s. Without P it would
// be continuous with the slope 2 K: a supremum of continuous functions, of which none depends on f as long as
// the stroke goes away by less than `turn` in between, so that the chart sees one visit. Other visits count
// the less the farther the stroke went away, and have sheets of their own. But beside a straight line it
// would exceed e(f) by a share of m, with a crease along the stroke. P takes that away; in return E has a
// step, where f changes, of P at the most, (K - sqrt(K^2 - 1)) m = 0.35 m for K = 1.6 instead of up to pi m.
// Costs O(1) per position, near an end that bends sharply O(reach / spacing).
#include <burin/stroke/curve/end_distances.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace burin {
namespace {

/// K.
constexpr float slope = 1.6F;

/// The distance of the points at which the stroke is looked at, and by how much it must move away and come
/// back to visit a position again, as in chart/path/visit.h, in radii.
constexpr double spacing_over_radius = 1. / 8, turn_over_radius = 1. / 8;

/// Along so much of a stroke, in radii, that bends less sharply than its radius it goes away by more than two
/// radii, so that what comes later is another visit.
constexpr double least_way_round = 3;

/// A point of the curve that is `away` from one of its ends along it.
struct Place {
  double away;
  Vec3f position;
};

/// The places of the curve from one end on, up to the first that is farther than `most` away.
std::vector<Place> places_from(const SurfaceCurve& curve, bool end, double most,
                               const EndDistances::Image& image) {
  std::vector<Place> places;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i < count && (places.empty() || places.back().away <= most); ++i) {
    const CurvePoint& point = curve.points[end ? count - 1 - i : i];
    const Vec3f& position = point.at.position;
    places.push_back({end ? curve.length() - point.t : point.t, image ? image(position) : position});
  }
  return places;
}

/// The positions at multiples of `spacing` of the arc length, up to `most`.
std::vector<Vec3f> resampled(const std::vector<Place>& places, double spacing, double most) {
  std::vector<Vec3f> positions;
  std::size_t segment = 0;
  for (double t = 0; t <= most; t = spacing * static_cast<double>(positions.size())) {
    while (segment + 2 < places.size() && places[segment + 1].away <= t) ++segment;
    const Place &from = places[segment], &to = places[std::min(segment + 1, places.size() - 1)];
    const double share = to.away > from.away ? std::min((t - from.away) / (to.away - from.away), 1.) : 0;
    positions.push_back(from.position + static_cast<float>(share) * (to.position - from.position));
  }
  return positions;
}

/// P: how much more a point of a line counts than the nearest one if it is `along` farther from the end.
float gain_beside_line(float along, float distance) {
  return std::max(0.F, along - slope * (std::sqrt(distance * distance + along * along) - distance));
}

/// Whether the angle between neighbouring chords of two spacings, a quarter of the radius, exceeds that of a
/// circle whose radius is that of the stroke, less a tenth.
bool bends_sharply(std::span<const Vec3f> points) {
  constexpr std::size_t chord = 2;
  constexpr float cosine = 0.9751F;  // of 0.9 / 4
  for (std::size_t i = 2 * chord; i < points.size(); ++i) {
    const Vec3f before = points[i - chord] - points[i - 2 * chord], after = points[i] - points[i - chord];
    if (before.dot(after) < cosine * std::sqrt(before.squaredNorm() * after.squaredNorm())) return true;
  }
  return false;
}

}  // namespace

EndDistances::EndDistances(double most) : most_(std::min<double>(most, std::numeric_limits<float>::max())) {}

EndDistances::EndDistances(const SurfaceCurve& curve, double radius, double most, const Image& image)
    : EndDistances(most) {
  if (curve.closed || !(most_ > 0)) return;
  has_ends_ = true;
  length_ = curve.length();
  radius_ = radius;
  rounding_ = std::clamp(2 * most_ - length_, 0., std::min(radius / 2, length_));
  const double copied = std::min(length_, most_ + reach(radius_, most_));
  begin_ = end_of(resampled(places_from(curve, false, copied, image), spacing(), copied));
  end_ = end_of(resampled(places_from(curve, true, copied, image), spacing(), copied));
  // Where the ends meet they are told the same way.
  if (length_ <= 2 * most_) begin_.bends = end_.bends = begin_.bends || end_.bends;
}

double EndDistances::spacing() const { return spacing_over_radius * radius_; }

EndDistances::End EndDistances::end_of(std::vector<Vec3f> points) const {
  End end{std::move(points)};
  const double seen = std::min(most_ + least_way_round * radius_, length_);
  const std::size_t count = std::min(end.points.size(), static_cast<std::size_t>(seen / spacing()) + 1);
  end.bends = bends_sharply(std::span(end.points).first(count));
  return end;
}

float EndDistances::at(double t, double d, const Vec3f& e1, const Vec3f& normal) const {
  const double nearer = std::min(t, length_ - t);
  if (!has_ends_ || nearer >= most_) return static_cast<float>(most_);
  const bool at_begin = t < length_ - t;
  const auto on_stroke = static_cast<float>(std::clamp(along(nearer), 0., most_));
  const End& end = at_begin ? begin_ : end_;
  if (!end.bends) return on_stroke;
  const double past = nearer > 0 ? 0 : at_begin ? nearer : -nearer;
  const Vec3f from_foot = static_cast<float>(past) * e1 + static_cast<float>(d) * normal.cross(e1);
  return std::max(on_stroke,
                  std::min(supremum(end, std::max(nearer, 0.), from_foot), static_cast<float>(most_)));
}

/// The smaller one of s and length - s, with its corner rounded off in the middle of short strokes.
double EndDistances::along(double s) const {
  const double other = length_ - s, over = rounding_ - std::abs(s - other);
  return std::min(s, other) - (over > 0 ? over * over / (4 * rounding_) : 0);
}

/// The supremum for the position that lies away by `from_foot` from the stroke at t. Since the directions of
/// a chart turn along its rays with the surface, that is off by half of the turn times d, along the normal.
float EndDistances::supremum(const End& end, double t, const Vec3f& from_foot) const {
  const std::vector<Vec3f>& points = end.points;
  const auto first = static_cast<std::size_t>(t / spacing());
  const auto share = static_cast<float>(t / spacing() - static_cast<double>(first));
  const Vec3f foot =
      first + 1 < points.size() ? points[first] + share * (points[first + 1] - points[first]) : points.back();
  const Vec3f position = foot + from_foot;
  const double until = std::min(length_ - t, t + reach(radius_, most_));
  const auto turn = static_cast<float>(turn_over_radius * radius_), most = static_cast<float>(most_);
  const float distance = from_foot.norm();
  float nearest = distance, farthest = distance, best = static_cast<float>(along(t)) - slope * distance;
  for (std::size_t i = first + 1; i < points.size(); ++i) {
    const double s = spacing() * static_cast<double>(i);
    if (s > until) break;
    const float away = (points[i] - position).norm();
    nearest = std::min(nearest, away);
    farthest = std::max(farthest, away);
    const float least_cost = slope * (farthest - turn);
    const float value = std::min(static_cast<float>(along(s)), most) - std::max(slope * away, least_cost);
    if (value > best) best = std::max(best, value - gain_beside_line(static_cast<float>(s - t), distance));
    if (most - least_cost <= best) break;
  }
  return best + slope * nearest;
}

}  // namespace burin
