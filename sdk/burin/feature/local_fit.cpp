// Local polynomial regression on the nodes of a chart. The basis is v^0 to v^4, u, uv, uv^2, uv^3, u^2,
// u^2 v, u^2 v^2 in shares u along and v across the stroke of the window's reach.
#include <burin/feature/local_fit.h>
#include <burin/surface/geometry/quadratic_fit.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using Row = Eigen::Matrix<double, LocalFit::terms, 1>;
using Squares = Eigen::Matrix<double, LocalFit::terms, LocalFit::terms>;

struct Sums {
  Squares squares = Squares::Zero();
  LocalFit::Terms right = LocalFit::Terms::Zero();
  double weight = 0, squared_weight = 0, squared_value = 0;
  int count = 0;

  void add(double u, double v, double w, const Vec2d& values) {
    const double v2 = v * v, uu = u * u;
    Row row;
    row << 1, v, v2, v2 * v, v2 * v2, u, u * v, u * v2, u * v2 * v, uu, uu * v, uu * v2;
    const Row weighted = w * row;
    squares.noalias() += weighted * row.transpose();
    right.noalias() += weighted * values.transpose();
    weight += w;
    squared_weight += w * w;
    squared_value += w * values[1] * values[1];
    ++count;
  }
};

Sums sums_of(const ChartSamples& samples, const FitWindow& window,
             const std::function<Vec2d(const ChartSample&)>& values) {
  Sums sums;
  const int first = std::max(0, static_cast<int>(std::ceil(window.middle.x() - window.reach.x())));
  const int last = std::min(samples.grid().columns - 1,
                            static_cast<int>(std::floor(window.middle.x() + window.reach.x())));
  for (int column = first; column <= last; ++column) {
    for (const ChartSample& sample : samples.column(column)) {
      const double u = (static_cast<double>(sample.x) - window.middle.x()) / window.reach.x();
      const double v = (static_cast<double>(sample.y) - window.middle.y()) / window.reach.y();
      const double w = static_cast<double>(sample.area) * bump_weight(u * u) * bump_weight(v * v);
      if (w > 0) sums.add(u, v, w, values(sample));
    }
  }
  return sums;
}

}  // namespace

std::optional<LocalFit> LocalFit::make(const ChartSamples& samples, const FitWindow& window,
                                       const std::function<Vec2d(const ChartSample&)>& values) {
  const Sums sums = sums_of(samples, window, values);
  if (sums.count < 3 * terms / 2) return std::nullopt;
  const Eigen::LDLT<Squares> solver(sums.squares);
  constexpr double smallest_share = 1e-9;
  if (!(solver.vectorD().minCoeff() > smallest_share * sums.weight)) return std::nullopt;
  LocalFit fit;
  fit.terms_ = solver.solve(sums.right);
  const double left = sums.squared_value - fit.terms_.col(1).dot(sums.right.col(1));
  // The residuals' mean square, times the weight of a typical sample.
  fit.residual_ = std::max(left, 0.) / sums.weight * (sums.squared_weight / sums.weight);
  for (int i = 0; i < 5; ++i) fit.inverse_[i] = solver.solve(Row::Unit(i))[i];
  return fit;
}

Vec2d LocalFit::derivative(int order, double v) const {
  Vec2d sum = Vec2d::Zero();
  for (int power = 4; power >= order; --power) {
    double factor = 1;
    for (int k = 0; k < order; ++k) factor *= power - k;
    sum = sum * v + factor * terms_.row(power).transpose();
  }
  return sum;
}

Vec2d LocalFit::slope_along(double v) const {
  constexpr int first = 5;  // of the terms u, uv, uv^2, uv^3
  Vec2d sum = Vec2d::Zero();
  for (int power = 3; power >= 0; --power) sum = sum * v + terms_.row(first + power).transpose();
  return sum;
}

double LocalFit::variance(int order) const {
  double factor = 1;
  for (int k = 2; k <= order; ++k) factor *= k;
  return factor * factor * residual_ * inverse_[order];
}

std::optional<double> root_near_0(const std::function<Vec2d(double)>& f, double most) {
  constexpr int steps = 6;
  double v = 0;
  for (int i = 0; i < steps; ++i) {
    const Vec2d at = f(v);
    v -= at[0] / at[1];
    if (!(std::abs(v) <= most)) return std::nullopt;
  }
  return v;
}

}  // namespace burin
