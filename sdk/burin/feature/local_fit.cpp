// Local polynomial regression on the nodes of a chart. The basis is v^0 to v^4, u, uv, uv^2, uv^3, u^2,
// u^2 v, u^2 v^2 in shares u along and v across the stroke of the window's reach.
#include <burin/feature/local_fit.h>
#include <burin/surface/geometry/quadratic_fit.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace burin {
namespace {

using Row = Eigen::Matrix<double, LocalFit::terms, 1>;
using Squares = Eigen::Matrix<double, LocalFit::terms, LocalFit::terms>;

/// The powers of u and of v of each term.
constexpr std::array<std::array<std::size_t, 2>, LocalFit::terms> powers = {
    {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 0}, {2, 1}, {2, 2}}};

/// Samples in a window, padded to whole lanes by such without weight.
struct Gathered {
  static constexpr std::size_t lanes = 2;
  std::vector<double> u, v, weight, first, second;
  int count = 0;

  void add(double at_u, double at_v, double w, const Vec2d& values) {
    u.push_back(at_u);
    v.push_back(at_v);
    weight.push_back(w);
    first.push_back(values[0]);
    second.push_back(values[1]);
  }

  void pad() {
    count = static_cast<int>(u.size());
    while (u.size() % lanes != 0) add(0, 0, 0, Vec2d::Zero());
  }
};

/// Sums over samples, lane by lane. Products of terms are powers of u up to 4 times powers of v up to 8, of
/// which there are fewer than pairs of terms.
struct Sums {
  using Lanes = Eigen::Array<double, Gathered::lanes, 1>;
  static constexpr int powers_of_u = 5, powers_of_v = 9;
  std::array<std::array<Lanes, powers_of_v>, powers_of_u> moments;
  std::array<std::array<Lanes, LocalFit::terms>, 2> right;
  Lanes squared_weight = Lanes::Zero(), squared_value = Lanes::Zero();

  Sums() {
    for (auto& row : moments) row.fill(Lanes::Zero());
    for (auto& row : right) row.fill(Lanes::Zero());
  }

  explicit Sums(const Gathered& samples) : Sums() {
    const auto lanes_of = [](const std::vector<double>& of, std::size_t at) {
      return Lanes(Eigen::Map<const Lanes>(&of[at]));
    };
    for (std::size_t i = 0; i < samples.u.size(); i += Gathered::lanes)
      add(lanes_of(samples.u, i), lanes_of(samples.v, i), lanes_of(samples.weight, i),
          {lanes_of(samples.first, i), lanes_of(samples.second, i)});
  }

  /// Flattened because a call per lane expression would cost more than the expression.
  [[gnu::flatten]] void add(const Lanes& u, const Lanes& v, const Lanes& w,
                            const std::array<Lanes, 2>& values) {
    Lanes of_u = w;
    std::size_t term = 0;
    for (int i = 0; i < powers_of_u; ++i, of_u *= u) {
      Lanes product = of_u;
      // Terms have the powers of v up to 4 - i; pairs of them whose powers of u sum up to i those up to 8 -
      // i.
      for (int k = 0; k < powers_of_v - i; ++k, product *= v) {
        moments[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] += product;
        if (i > 2 || k > 4 - i) continue;
        right[0][term] += product * values[0];
        right[1][term++] += product * values[1];
      }
    }
    squared_weight += w * w;
    squared_value += w * values[1] * values[1];
  }

  double weight() const { return moments[0][0].sum(); }

  Squares squares() const {
    Squares result;
    for (std::size_t i = 0; i < powers.size(); ++i)
      for (std::size_t k = 0; k < powers.size(); ++k)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
            moments[powers[i][0] + powers[k][0]][powers[i][1] + powers[k][1]].sum();
    return result;
  }

  LocalFit::Terms right_side() const {
    LocalFit::Terms result;
    for (std::size_t side = 0; side < right.size(); ++side)
      for (std::size_t i = 0; i < powers.size(); ++i)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(side)) = right[side][i].sum();
    return result;
  }
};

Gathered gathered(const ChartSamples& samples, const FitWindow& window,
                  const std::function<Vec2d(const ChartSample&)>& values) {
  Gathered result;
  const int first = std::max(0, static_cast<int>(std::ceil(window.middle.x() - window.reach.x())));
  const int last = std::min(samples.grid().columns - 1,
                            static_cast<int>(std::floor(window.middle.x() + window.reach.x())));
  for (int column = first; column <= last; ++column) {
    for (const ChartSample& sample : samples.column(column)) {
      const double u = (static_cast<double>(sample.x) - window.middle.x()) / window.reach.x();
      const double v = (static_cast<double>(sample.y) - window.middle.y()) / window.reach.y();
      if (!(std::abs(v) < 1)) continue;
      const double w = static_cast<double>(sample.area) * bump_weight(u * u) * bump_weight(v * v);
      if (w > 0) result.add(u, v, w, values(sample));
    }
  }
  result.pad();
  return result;
}

}  // namespace

std::optional<LocalFit> LocalFit::make(const ChartSamples& samples, const FitWindow& window,
                                       const std::function<Vec2d(const ChartSample&)>& values) {
  const Gathered within = gathered(samples, window, values);
  if (within.count < 3 * terms / 2) return std::nullopt;
  const Sums sums(within);
  const Eigen::LDLT<Squares> solver(sums.squares());
  constexpr double smallest_share = 1e-9;
  if (!(solver.vectorD().minCoeff() > smallest_share * sums.weight())) return std::nullopt;
  LocalFit fit;
  const Terms right = sums.right_side();
  fit.terms_ = solver.solve(right);
  const double left = sums.squared_value.sum() - fit.terms_.col(1).dot(right.col(1));
  // The residuals' mean square, times the weight of a typical sample.
  fit.residual_ = std::max(left, 0.) / sums.weight() * (sums.squared_weight.sum() / sums.weight());
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
