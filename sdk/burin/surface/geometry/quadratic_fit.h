#pragma once
#include <burin/base/vector.h>

#include <Eigen/Cholesky>
#include <array>
#include <cstddef>

namespace burin {

/// A smooth bump over the unit disc: 1 in the middle, 0 from the rim on, with two continuous derivatives.
inline double bump_weight(double squared_radius) {
  const double inside = squared_radius < 1 ? 1 - squared_radius : 0;
  return inside * inside * inside;
}

/// The weighted least-squares quadratic z(x, y) of points around (0, 0), weighted by bump_weight() over the
/// reach. Sums are accumulated in floats. A point costs O(1), solve() solves a 6 x 6 system.
class QuadraticFit {
 public:
  using Terms = Eigen::Matrix<double, 6, 1>;  ///< z, z_x, z_y, z_xx, z_xy, z_yy at (0, 0)

  /// `reach`: in units of x and y.
  explicit QuadraticFit(double reach) : inverse_(1 / reach) {
    moments_.fill(Lanes::Zero());
    right_.fill(Lanes::Zero());
  }

  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;

  /// Adds a point (x, y, z).
  void add(const Vec3f& at) {
    x_[waiting_] = at.x();
    y_[waiting_] = at.y();
    z_[waiting_] = at.z();
    counts_[waiting_] = 1;
    if (++waiting_ == lanes) add_waiting();
  }

  /// Adds one point per lane, each with an additional weight. The function is flattened because a call per
  /// lane expression would cost more than the expression.
  [[gnu::flatten]] void add(const Lanes& at_x, const Lanes& at_y, const Lanes& z, const Lanes& counts) {
    const auto inverse = static_cast<float>(inverse_);
    const Lanes x = at_x * inverse, y = at_y * inverse;
    const Lanes xx = x * x, xy = x * y, yy = y * y, inside = (1 - (xx + yy)).max(0.F);
    const Lanes w = counts * inside * inside * inside;
    const Lanes wx = w * x, wy = w * y, wxx = w * xx, wxy = w * xy, wyy = w * yy;
    const std::array<const Lanes*, 6> first = {&w, &wx, &wy, &wxx, &wxy, &wyy};
    for (std::size_t i = 0; i < first.size(); ++i) {
      moments_[i] += *first[i];
      right_[i] += *first[i] * z;
    }
    moments_[6] += wxx * x;
    moments_[7] += wxx * y;
    moments_[8] += wyy * x;
    moments_[9] += wyy * y;
    moments_[10] += wxx * xx;
    moments_[11] += wxx * xy;
    moments_[12] += wxx * yy;
    moments_[13] += wyy * xy;
    moments_[14] += wyy * yy;
  }

  /// The coefficients; those that the points do not determine are 0.
  Terms solve() {
    for (; waiting_ > 0; add_waiting())
      for (; waiting_ < lanes; ++waiting_) x_[waiting_] = y_[waiting_] = z_[waiting_] = counts_[waiting_] = 0;
    if (!(total(moments_[0]) > 0)) return Terms::Zero();
    std::array<double, 15> sums{};
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = total(moments_[i]);
    // The unknowns are the coefficients of 1, x, y, x^2, x y, y^2.
    const auto& [w, x, y, xx, xy, yy, xxx, xxy, xyy, yyy, xxxx, xxxy, xxyy, xyyy, yyyy] = sums;
    Eigen::Matrix<double, 6, 6> squares;
    squares << w, x, y, xx, xy, yy,      //
        x, xx, xy, xxx, xxy, xyy,        //
        y, xy, yy, xxy, xyy, yyy,        //
        xx, xxx, xxy, xxxx, xxxy, xxyy,  //
        xy, xxy, xyy, xxxy, xxyy, xyyy,  //
        yy, xyy, yyy, xxyy, xyyy, yyyy;
    constexpr double damping = 2e-7;
    squares.diagonal().tail<5>().array() += damping * w;
    Terms right;
    for (Eigen::Index i = 0; i < 6; ++i) right[i] = total(right_[static_cast<std::size_t>(i)]);
    const Terms terms = squares.llt().solve(right);
    const double first = inverse_, second = inverse_ * inverse_;
    return {terms[0],          first * terms[1],     first * terms[2], 2 * second * terms[3],
            second * terms[4], 2 * second * terms[5]};
  }

 private:
  static double total(const Lanes& sums) {
    const Eigen::Array4f halves = sums.head<4>() + sums.tail<4>();
    return static_cast<double>((halves[0] + halves[2]) + (halves[1] + halves[3]));
  }

  void add_waiting() {
    waiting_ = 0;
    add(x_, y_, z_, counts_);
  }

  double inverse_;  ///< 1 / reach
  int waiting_ = 0;
  Lanes x_, y_, z_, counts_;  ///< points that wait until there is one per lane
  std::array<Lanes, 15> moments_;
  std::array<Lanes, 6> right_;
};

}  // namespace burin
