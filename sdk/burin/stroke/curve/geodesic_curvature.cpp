// Estimates the geodesic curvature of a polyline on a surface as the derivative of the angle by which its
// tangent turns against parallel transport: a local least-squares polynomial at each point (Savitzky and
// Golay 1964, for uneven spacing). O(points in the window) per point that changed.
#include <burin/stroke/curve/geodesic_curvature.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// A larger turn between neighbouring points, radians, is a corner of the stroke.
constexpr double corner = 0.5;

/// After this much turn on one side, radians, the window contains a bend tighter than itself and is extended
/// by a few points only.
constexpr double bend = 0.7;
constexpr int points_beyond_bend = 2;

/// The number of points on a side of the window that is enough for the fit. Twice as many are thinned out,
/// since they would cost time and add no accuracy.
constexpr std::ptrdiff_t enough_points = 64;

/// The step from one used point to the next on one side of the window.
std::size_t stride(const SurfaceCurve& curve, std::size_t point, double reach, bool forward) {
  if (curve.closed) return 1;
  const auto& points = curve.points;
  const auto end =
      std::ranges::upper_bound(points, points[point].t + (forward ? reach : -reach), {}, &CurvePoint::t);
  const std::ptrdiff_t count = std::abs(end - points.begin() - static_cast<std::ptrdiff_t>(point));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(count / enough_points, 1));
}

/// A least-squares polynomial fitted to values at abscissas around 0, which are scaled by the reach.
class LocalFit {
 public:
  explicit LocalFit(double reach) : reach_(reach) {}

  void add(double place, double value) {
    const double x = place / reach_;
    const Eigen::Vector4d powers(1, x, x * x, x * x * x);
    normal_ += powers * powers.transpose();
    right_ += value * powers;
    ++count_;
  }

  /// The slope at 0 of the polynomial of this degree, 1 to 3, or of a lower degree if there are few points.
  double slope(Eigen::Index degree) const {
    const Eigen::Index terms = std::min<Eigen::Index>(degree + 1, count_ / 2);
    if (terms < 2) return 0;
    const Eigen::VectorXd solution = normal_.topLeftCorner(terms, terms).ldlt().solve(right_.head(terms));
    return solution[1] / reach_;
  }

 private:
  double reach_;
  Eigen::Index count_ = 0;
  Eigen::Matrix4d normal_ = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right_ = Eigen::Vector4d::Zero();
};

}  // namespace

std::size_t GeodesicCurvature::update(const SurfaceCurve& curve, double window, std::size_t first_changed) {
  const auto& points = curve.points;
  if (curve.closed) first_changed = 0;
  turn_.update(curve, first_changed);
  // The estimate of a point may change if its window reaches beyond the last unchanged point.
  const double unchanged = first_changed > 0 ? points[first_changed - 1].t : 0;
  while (first_changed > 0 && points[first_changed - 1].t + window >= unchanged) --first_changed;
  curvature_.resize(points.size());
  for (std::size_t i = first_changed; i < points.size(); ++i) curvature_[i] = slope_at(curve, window, i);
  return first_changed;
}

float GeodesicCurvature::slope_at(const SurfaceCurve& curve, double window, std::size_t point) const {
  const auto& points = curve.points;
  const double t = points[point].t, length = curve.length();
  const double to_end = curve.closed ? length / 2 : std::min(t, length - t);
  const double reach = std::clamp(to_end, window / 2, window);
  LocalFit fit(reach);
  fit.add(0, 0);
  double most_turned = 0;
  const auto walk = [&](bool forward) {
    const std::size_t step = stride(curve, point, reach, forward);
    double place = 0, angle = 0;
    int beyond = 0;
    for (std::size_t i = point;;) {
      const bool wraps = forward ? i + 1 == points.size() : i == 0;
      if (wraps && !curve.closed) return;
      const std::size_t next = forward ? wraps ? 0 : std::min(i + step, points.size() - 1)
                               : wraps ? points.size() - 1
                                       : i - std::min(i, step);
      const std::size_t from = forward ? i : next, to = forward ? next : i;
      const double turned = wraps ? turn_.closing() : turn_.at(to) - turn_.at(from);
      const double extent = (wraps ? length : points[to].t) - points[from].t;
      place += forward ? extent : -extent;
      angle += forward ? turned : -turned;
      if (std::abs(place) > reach || std::abs(turned) > corner || next == point) return;
      if (std::abs(angle) > bend && ++beyond > points_beyond_bend) return;
      fit.add(place, angle);
      most_turned = std::max(most_turned, std::abs(angle));
      i = next;
    }
  };
  walk(true);
  walk(false);
  // Beside a sharp bend, parabolas and cubics overshoot to the wrong sign.
  return static_cast<float>(fit.slope(most_turned > bend / 2 ? 1 : to_end < reach ? 2 : 3));
}

}  // namespace burin
