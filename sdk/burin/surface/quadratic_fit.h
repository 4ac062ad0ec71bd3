#pragma once
#include <burin/base/vector.h>

#include <Eigen/Cholesky>
#include <array>
#include <cstddef>

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
  explicit QuadraticFit(double reach) : inverse_(1 / reach) {}

  /// A place (x, y, z).
  void add(const Vec3f& at, double weight) {
    const double x = static_cast<double>(at.x()) * inverse_, y = static_cast<double>(at.y()) * inverse_;
    const double xx = x * x, xy = x * y, yy = y * y, w = weight * bump_weight(xx + yy);
    const double wx = w * x, wy = w * y, wxx = w * xx, wxy = w * xy, wyy = w * yy;
    const double z = static_cast<double>(at.z());
    const std::array<double, 15> moments = {w,        wx,       wy,       wxx,      wxy,
                                            wyy,      wxx * x,  wxx * y,  wyy * x,  wyy * y,
                                            wxx * xx, wxx * xy, wxx * yy, wyy * xy, wyy * yy};
    for (std::size_t i = 0; i < moments.size(); ++i) moments_[i] += moments[i];
    for (std::size_t i = 0; i < right_.size(); ++i) right_[i] += moments[i] * z;
  }

  /// What the places do not tell is 0.
  Terms solve() const {
    if (!(moments_[0] > 0)) return Terms::Zero();
    // In 1, x, y, x^2, x y, y^2.
    const auto& [w, x, y, xx, xy, yy, xxx, xxy, xyy, yyy, xxxx, xxxy, xxyy, xyyy, yyyy] = moments_;
    Eigen::Matrix<double, 6, 6> squares;
    squares << w, x, y, xx, xy, yy,      //
        x, xx, xy, xxx, xxy, xyy,        //
        y, xy, yy, xxy, xyy, yyy,        //
        xx, xxx, xxy, xxxx, xxxy, xxyy,  //
        xy, xxy, xyy, xxxy, xxyy, xyyy,  //
        yy, xyy, yyy, xxyy, xyyy, yyyy;
    constexpr double damping = 2e-7;
    squares.diagonal().tail<5>().array() += damping * w;
    const Terms terms = squares.ldlt().solve(Terms(right_.data()));
    const double first = inverse_, second = inverse_ * inverse_;
    return {terms[0],          first * terms[1],     first * terms[2], 2 * second * terms[3],
            second * terms[4], 2 * second * terms[5]};
  }

 private:
  double inverse_;  ///< of the reach
  std::array<double, 15> moments_{};
  std::array<double, 6> right_{};
};

}  // namespace burin
