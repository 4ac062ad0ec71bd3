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
// Costs O(1) per position, near an end that bends sharply O(reach / spacing), for eight points at a time.
#include <burin/stroke/curve/end_distances.h>

#include <Eigen/Core>
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

/// Numbers of as many points of the stroke.
using Lanes = Eigen::Array<float, 8, 1>;
constexpr std::size_t lanes = Lanes::SizeAtCompileTime;

/// P: how much more points of a line count than the nearest one if they are `along` farther from the end.
Lanes gains_beside_line(const Lanes& along, float distance) {
  return (along - slope * ((distance * distance + along.square()).sqrt() - distance)).max(0);
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
  if (length_ <= 2 * most_ && begin_.bends != end_.bends) {
    split(begin_.bends ? end_ : begin_);
    begin_.bends = end_.bends = true;
  }
}

double EndDistances::spacing() const { return spacing_over_radius * radius_; }

EndDistances::End EndDistances::end_of(std::vector<Vec3f> points) const {
  End end;
  end.points = std::move(points);
  const double seen = std::min(most_ + least_way_round * radius_, length_);
  const std::size_t count = std::min(end.points.size(), static_cast<std::size_t>(seen / spacing()) + 1);
  end.bends = bends_sharply(std::span(end.points).first(count));
  if (end.bends) split(end);
  return end;
}

/// Fills what the supremum reads.
void EndDistances::split(End& end) const {
  const std::size_t count = end.points.size();
  for (std::size_t i = 0; i < count + lanes; ++i) {
    const Vec3f& point = end.points[std::min(i, count - 1)];
    end.x.push_back(point.x());
    end.y.push_back(point.y());
    end.z.push_back(point.z());
  }
  for (std::size_t i = 0; i < count; ++i)
    end.told.push_back(static_cast<float>(std::min(along(spacing() * static_cast<double>(i)), most_)));
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
  const std::size_t count = std::min(points.size(), static_cast<std::size_t>(until / spacing()) + 1);
  const auto turn = static_cast<float>(turn_over_radius * radius_), most = static_cast<float>(most_);
  const float distance = from_foot.norm();
  float nearest = distance, farthest = distance, best = static_cast<float>(along(t)) - slope * distance;
  for (std::size_t block = first + 1; block < count; block += lanes) {
    const auto at = [block](const std::vector<float>& of) { return Eigen::Map<const Lanes>(&of[block]); };
    const Lanes squared = (at(end.x) - position.x()).square() + (at(end.y) - position.y()).square() +
                          (at(end.z) - position.z()).square();
    const Lanes away = squared.sqrt(),
                after = static_cast<float>(block - first) - share + Lanes::LinSpaced(0, lanes - 1);
    const Lanes gains = gains_beside_line(static_cast<float>(spacing()) * after, distance);
    const auto here = static_cast<Eigen::Index>(std::min(lanes, count - block));
    const float* told = &end.told[block];
    for (Eigen::Index i = 0; i < here; ++i) {
      nearest = std::min(nearest, away[i]);
      farthest = std::max(farthest, away[i]);
      const float least_cost = slope * (farthest - turn);
      best = std::max(best, told[i] - std::max(slope * away[i], least_cost) - gains[i]);
      if (most - least_cost <= best) return best + slope * nearest;
    }
  }
  return best + slope * nearest;
}

}  // namespace burin
