#include <burin/stroke/geodesic_curvature.h>
#include <burin/surface/parallel_transport.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The angle by which the tangent has turned since the first point, radians.
std::vector<double> turning_angles(const std::vector<CurvePoint>& points) {
  std::vector<double> angles(points.size(), 0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3f& normal = points[i].normal;
    const Vec3f carried = transport(points[i - 1].tangent, points[i - 1].normal, normal);
    const double sine = normal.cross(carried).dot(points[i].tangent);
    angles[i] = angles[i - 1] + std::atan2(sine, static_cast<double>(carried.dot(points[i].tangent)));
  }
  return angles;
}

/// Least-squares polynomial through values over places around 0, in units of the reach.
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

  /// Of the polynomial of this degree, 1 to 3, or less where points are few.
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

std::vector<float> geodesic_curvature(const SurfaceCurve& curve, double window) {
  const auto& points = curve.points;
  const std::vector<double> angles = turning_angles(points);
  std::vector<float> curvature(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = points[i].t, to_end = std::min(t, curve.length() - t);
    const double reach = std::clamp(to_end, window / 2, window);
    LocalFit fit(reach);
    for (std::size_t j = i; j < points.size() && points[j].t <= t + reach; ++j)
      fit.add(points[j].t - t, angles[j]);
    for (std::size_t j = i; j-- > 0 && points[j].t >= t - reach;) fit.add(points[j].t - t, angles[j]);
    curvature[i] = static_cast<float>(fit.slope(to_end < reach ? 2 : 3));
  }
  return curvature;
}

}  // namespace burin
