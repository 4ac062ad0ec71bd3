// Moving averages by prefix sums: the integrals of positions and normals up to every point, so that a mean
// over any interval is a difference of two integrals. O(points) to build, O(log points) per query.
#include <burin/stroke/curve/foot_line.h>

#include <algorithm>
#include <cmath>

namespace burin {

FootLine::FootLine(const SurfaceCurve& curve, double reach) : reach_(reach), closed_(curve.closed) {
  const auto append = [&](const CurvePoint& point, double t) {
    t_.push_back(t);
    position_.push_back(point.at.position.cast<double>());
    normal_.push_back(point.normal.cast<double>());
    const std::size_t last = t_.size() - 1;
    sums_.push_back(last == 0 ? Sum{Vec3d::Zero(), Vec3d::Zero()} : sum_within(t));
  };
  for (const CurvePoint& point : curve.points) append(point, point.t);
  if (closed_) append(curve.points.front(), curve.length());
}

FootPlane FootLine::at(double t) const {
  const double length = t_.back();
  const double middle = closed_ ? t : std::clamp(t, 0.0, length);
  const double from = closed_ ? middle - reach_ : std::max(middle - reach_, 0.0);
  const double to = closed_ ? middle + reach_ : std::min(middle + reach_, length);
  if (!(to > from) || !(length > 0)) return {position_[0].cast<float>(), normal_[0].cast<float>()};
  const Sum before = sum_to(from), after = sum_to(to);
  const Vec3d normal = after.normal - before.normal;
  const Vec3d position = (after.position - before.position) / (to - from);
  // If the normals nearly cancel out, their mean has no reliable direction.
  const bool clear = normal.norm() > 0.1 * (to - from);
  const double within = closed_ ? middle - std::floor(middle / length) * length : middle;
  const Vec3d own = normal_[segment_at(within)];
  return {position.cast<float>(), (clear ? normal.normalized() : own).cast<float>()};
}

/// The integrals from the first point to t: any t of a closed curve, or t in [0, length] of an open one.
FootLine::Sum FootLine::sum_to(double t) const {
  if (!closed_) return sum_within(t);
  const double turns = std::floor(t / t_.back());
  const Sum rest = sum_within(t - turns * t_.back());
  return {turns * sums_.back().position + rest.position, turns * sums_.back().normal + rest.normal};
}

/// The integrals from the first point to t, with t in [0, length]. Positions and normals are linear between
/// points.
FootLine::Sum FootLine::sum_within(double t) const {
  const std::size_t i = sums_.size() < t_.size() ? t_.size() - 2 : segment_at(t);
  if (i + 1 >= t_.size()) return sums_[i];
  const double length = t_[i + 1] - t_[i], part = t - t_[i];
  const double s = length > 0 ? part / length : 0;
  const auto integral = [&](const std::vector<Vec3d>& values) {
    return Vec3d(part * (values[i] + s / 2 * (values[i + 1] - values[i])));
  };
  return {sums_[i].position + integral(position_), sums_[i].normal + integral(normal_)};
}

/// The index of the segment that contains t: the last point at or before t, except the last point of all.
std::size_t FootLine::segment_at(double t) const {
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const auto point = static_cast<std::size_t>(after - t_.begin());
  return std::clamp<std::size_t>(point, 1, std::max<std::size_t>(t_.size() - 1, 1)) - 1;
}

}  // namespace burin
