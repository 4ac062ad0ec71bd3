// Corners as places where parabolas through both sides of a line meet at an angle: at a smooth bend they go
// on into each other.
#include <burin/feature/corners.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// The nearest and the farthest places of a leg, scales from the corner.
constexpr double leg_begin = 1.4, leg_end = 5;

/// A fitted leg and how far places are from it.
struct FittedLeg {
  Leg leg;
  double misfit = 0;  ///< root of the mean square, object units
};

/// Fits a leg to places in their order away from the corner. Noise of a thirtieth of a scale is weighed
/// against bends of a radius of 100 scales, so that few places do not make a sharp bend of their noise.
std::optional<FittedLeg> fitted(const std::vector<Vec3d>& places, double scale) {
  constexpr std::size_t fewest = 3;
  constexpr double noise = 0.03, typical_bend = 100;
  if (places.size() < fewest) return std::nullopt;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < places.size(); ++i)
    along.push_back(along.back() + (places[i] - places[i - 1]).norm());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3d row(1, along[i], along[i] * along[i]);
    squares += row * row.transpose();
    right += row * places[i].transpose();
  }
  const double of_bend = noise * scale * typical_bend * scale;
  squares(2, 2) += of_bend * of_bend;
  const Eigen::Matrix3d terms = squares.ldlt().solve(right);
  FittedLeg result;
  for (std::size_t i = 0; i < 3; ++i) result.leg.terms[i] = terms.row(static_cast<Eigen::Index>(i));
  for (std::size_t i = 0; i < places.size(); ++i)
    result.misfit += (result.leg.position(along[i]) - places[i]).squaredNorm();
  result.misfit = std::sqrt(result.misfit / static_cast<double>(places.size()));
  return result;
}

/// Moves both legs' ends to where they are nearest to each other (Gauss and Newton). Returns their distance
/// there.
double meet(Leg& one, Leg& other, double start) {
  constexpr int steps = 8;
  one.to_corner = other.to_corner = start;
  for (int i = 0; i < steps; ++i) {
    const Vec3d apart = one.position(one.to_corner) - other.position(other.to_corner);
    const Vec3d a = one.direction(one.to_corner), b = -other.direction(other.to_corner);
    const double aa = a.squaredNorm(), ab = a.dot(b), bb = b.squaredNorm(), area = aa * bb - ab * ab;
    if (!(area > 1e-6 * aa * bb)) break;
    one.to_corner += (ab * b.dot(apart) - bb * a.dot(apart)) / area;
    other.to_corner += (ab * a.dot(apart) - aa * b.dot(apart)) / area;
  }
  return (one.position(one.to_corner) - other.position(other.to_corner)).norm();
}

/// A corner that there may be, and how badly it fits.
struct Candidate {
  Corner corner;
  double misfit = 0;  ///< object units
  int agreeing = 0;   ///< candidates, this one too
};

class CornerSearch {
 public:
  CornerSearch(std::span<const LinePlace> places, double scale) : places_(places), scale_(scale) {}

  std::optional<Candidate> at(double t) const {
    const auto before = fitted(leg_places(t, -1), scale_), after = fitted(leg_places(t, 1), scale_);
    if (!before || !after) return std::nullopt;
    Candidate found{{t, before->leg, after->leg, Vec3d::Zero()}, std::max(before->misfit, after->misfit)};
    constexpr double most_misfit = 0.1;
    Corner& corner = found.corner;
    const double gap = meet(corner.before, corner.after, -leg_begin * scale_);
    corner.position =
        (corner.before.position(corner.before.to_corner) + corner.after.position(corner.after.to_corner)) / 2;
    if (found.misfit > most_misfit * scale_ || !(gap < most_misfit * scale_)) return std::nullopt;
    const bool is_corner =
        is_ahead(corner.before) && is_ahead(corner.after) && turns(corner) && is_nearer(corner);
    return is_corner ? std::optional(found) : std::nullopt;
  }

 private:
  /// The places from one t to another.
  std::span<const LinePlace> places_between(double from, double to) const {
    const auto first = std::ranges::lower_bound(places_, from, {}, &LinePlace::t);
    return {first, std::ranges::upper_bound(first, places_.end(), to, {}, &LinePlace::t)};
  }

  /// The places of a leg to one side of t, away from it.
  std::vector<Vec3d> leg_places(double t, double side) const {
    const double near = t + side * leg_begin * scale_, far = t + side * leg_end * scale_;
    std::vector<Vec3d> result;
    for (const LinePlace& place : places_between(std::min(near, far), std::max(near, far)))
      result.push_back(place.position);
    if (side < 0) std::ranges::reverse(result);
    return result;
  }

  bool is_ahead(const Leg& leg) const {
    constexpr double farthest = 5;
    return leg.to_corner < 0 && leg.to_corner > -farthest * scale_;
  }

  static bool turns(const Corner& corner) {
    constexpr double cosine_of_least = 0.9063;  // 25 degrees
    const Vec3d in = -corner.before.direction(corner.before.to_corner).normalized();
    return in.dot(corner.after.direction(corner.after.to_corner).normalized()) < cosine_of_least;
  }

  /// Whether the corner is nearer to the places around it than the smoothed line.
  bool is_nearer(const Corner& corner) const {
    double of_corner = 0, of_smoothed = 0;
    for (const LinePlace& place : places_between(corner.t - leg_end * scale_, corner.t + leg_end * scale_)) {
      double squared = std::numeric_limits<double>::infinity();
      for (const Leg* leg : {&corner.before, &corner.after}) {
        const double x = std::max(leg->nearest(place.position), leg->to_corner);
        squared = std::min(squared, (leg->position(x) - place.position).squaredNorm());
      }
      of_corner += squared;
      of_smoothed += place.smoothed_away * place.smoothed_away;
    }
    return of_corner < of_smoothed;
  }

  std::span<const LinePlace> places_;
  double scale_;
};

/// Counts the candidates that agree where the corner is, although they leave out other places around it.
void count_agreeing(std::vector<Candidate>& candidates, double scale) {
  constexpr double near = 0.4;
  for (Candidate& one : candidates)
    one.agreeing = static_cast<int>(std::ranges::count_if(candidates, [&](const Candidate& other) {
      return std::abs(one.corner.t - other.corner.t) <= leg_end * scale &&
             (one.corner.position - other.corner.position).norm() <= near * scale;
    }));
}

}  // namespace

double Leg::nearest(const Vec3d& place) const {
  constexpr int steps = 6;  // of Newton's method
  double x = 0;
  for (int i = 0; i < steps; ++i) x += (place - position(x)).dot(direction(x)) / direction(x).squaredNorm();
  return x;
}

std::vector<Corner> corners_of(std::span<const LinePlace> places, double scale) {
  const CornerSearch search(places, scale);
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double next = places[std::min(i + 1, places.size() - 1)].t;
    for (const double t : {places[i].t, (places[i].t + next) / 2})
      if (auto candidate = search.at(t)) found.push_back(std::move(*candidate));
  }
  count_agreeing(found, scale);
  constexpr int fewest_agreeing = 3;
  std::erase_if(found, [](const Candidate& candidate) { return candidate.agreeing < fewest_agreeing; });
  std::ranges::stable_sort(
      found, {}, [](const Candidate& candidate) { return std::pair(-candidate.agreeing, candidate.misfit); });
  std::vector<Corner> corners;
  for (const Candidate& candidate : found)
    if (std::ranges::all_of(corners, [&](const Corner& corner) {
          return std::abs(corner.t - candidate.corner.t) > leg_end * scale;
        }))
      corners.push_back(candidate.corner);
  std::ranges::sort(corners, {}, &Corner::t);
  return corners;
}

}  // namespace burin
