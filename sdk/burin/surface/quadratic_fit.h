#pragma once
#include <burin/base/vector.h>

#include <Eigen/Cholesky>

namespace burin {

/// A smooth bump over the unit disc: 1 in the middle, 0 from the rim on with two derivatives.
inline double bump_weight(double squared_radius) {
  const double inside = squared_radius < 1 ? 1 - squared_radius : 0;
  return inside * inside * inside;
}

/// Weighted least-squares quadratics in (x, y) through values of `channels` functions at places around
/// (0, 0). Places count by bump_weight over the reach.
template <int channels>
class QuadraticFit {
 public:
  using Values = Eigen::Matrix<double, 1, channels>;
  using Terms = Eigen::Matrix<double, 6, channels>;  ///< value, x, y, xx, xy, yy derivatives at (0, 0)

  /// `reach`: in units of x and y.
  explicit QuadraticFit(double reach) : reach_(reach) {}

  void add(const Vec2f& at, const Values& values, double weight) {
    const Vec2d in = at.cast<double>() / reach_;
    Row row;
    row << 1, in.x(), in.y(), in.x() * in.x() / 2, in.x() * in.y(), in.y() * in.y() / 2;
    const double w = weight * bump_weight(in.squaredNorm());
    squares_ += w * row.transpose() * row;
    right_ += w * row.transpose() * values;
  }

  /// What the places do not tell is 0.
  Terms solve() const {
    if (!(squares_(0, 0) > 0)) return Terms::Zero();
    constexpr double damping = 1e-7;
    Eigen::Matrix<double, 6, 6> squares = squares_;
    squares.diagonal().template tail<5>().array() += damping * squares_(0, 0);
    Terms terms = squares.ldlt().solve(right_);
    terms.template middleRows<2>(1) /= reach_;
    terms.template bottomRows<3>() /= reach_ * reach_;
    return terms;
  }

 private:
  using Row = Eigen::Matrix<double, 1, 6>;

  double reach_;
  Eigen::Matrix<double, 6, 6> squares_ = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right_ = Terms::Zero();
};

}  // namespace burin
