#pragma once
#include <burin/base/vector.h>

#include <Eigen/Cholesky>

namespace burin {

/// A smooth bump over the unit disc: 1 in the middle, 0 from the rim on with two derivatives.
inline double bump_weight(double squared_radius) {
  const double inside = squared_radius < 1 ? 1 - squared_radius : 0;
  return inside * inside * inside;
}

/// The weighted least-squares quadratic z(x, y) through places around (0, 0), which count by bump_weight over
/// the reach.
class QuadraticFit {
 public:
  using Terms = Eigen::Matrix<double, 6, 1>;  ///< z, z_x, z_y, z_xx, z_xy, z_yy at (0, 0)

  /// `reach`: in units of x and y.
  explicit QuadraticFit(double reach) : reach_(reach) {}

  /// A place (x, y, z).
  void add(const Vec3f& at, double weight) {
    const Vec2d in = at.head<2>().cast<double>() / reach_;
    Terms row;
    row << 1, in.x(), in.y(), in.x() * in.x() / 2, in.x() * in.y(), in.y() * in.y() / 2;
    const double w = weight * bump_weight(in.squaredNorm());
    squares_ += w * row * row.transpose();
    right_ += w * static_cast<double>(at.z()) * row;
  }

  /// What the places do not tell is 0.
  Terms solve() const {
    if (!(squares_(0, 0) > 0)) return Terms::Zero();
    constexpr double damping = 1e-7;
    Eigen::Matrix<double, 6, 6> squares = squares_;
    squares.diagonal().tail<5>().array() += damping * squares_(0, 0);
    Terms terms = squares.ldlt().solve(right_);
    terms.segment<2>(1) /= reach_;
    terms.tail<3>() /= reach_ * reach_;
    return terms;
  }

 private:
  double reach_;
  Eigen::Matrix<double, 6, 6> squares_ = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right_ = Terms::Zero();
};

}  // namespace burin
