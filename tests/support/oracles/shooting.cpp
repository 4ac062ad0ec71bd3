#include "shooting.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace burin::test {
namespace {

using State = Eigen::Vector4d;  // x, y, x', y' over arc length

/// The geodesic equation of a height field: the acceleration in space is normal to the surface.
State derivative(const HeightField& field, const State& s) {
  const Height h = field(s[0], s[1]);
  const double bend =
      (h.fxx * s[2] * s[2] + 2 * h.fxy * s[2] * s[3] + h.fyy * s[3] * s[3]) / (1 + h.fx * h.fx + h.fy * h.fy);
  return {s[2], s[3], -h.fx * bend, -h.fy * bend};
}

State integrate(const HeightField& field, State s, double length, int steps) {
  const double h = length / steps;
  for (int i = 0; i < steps; ++i) {
    const State a = derivative(field, s), b = derivative(field, s + h / 2 * a);
    const State c = derivative(field, s + h / 2 * b), d = derivative(field, s + h * c);
    s += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return s;
}

Vec3d lifted(const Height& h, const Vec2d& v) { return {v.x(), v.y(), h.fx * v.x() + h.fy * v.y()}; }

}  // namespace

TriangleMesh field_mesh(const HeightField& field, int cells) {
  return shuffled(patch({.u_min = -1.3,
                         .u_max = 1.3,
                         .v_min = -1.3,
                         .v_max = 1.3,
                         .cells_u = cells,
                         .cells_v = cells,
                         .seed = 7},
                        [&](double x, double y) { return Vec3d(x, y, field(x, y).f); }),
                  3);
}

ShootingOracle::ShootingOracle(HeightField field, PlaneCurve curve)
    : field_(std::move(field)), curve_(std::move(curve)), lengths_{0} {
  constexpr int intervals = 4000;
  for (int i = 0; i < intervals; ++i) {
    const double a = static_cast<double>(i) / intervals, h = 1. / intervals;
    const auto speed = [&](double s) {
      const Vec2d p = curve_.place(s);
      return lifted(field_(p.x(), p.y()), curve_.derivative(s)).norm();
    };
    lengths_.push_back(lengths_.back() + h / 6 * (speed(a) + 4 * speed(a + h / 2) + speed(a + h)));
  }
}

Vec3d ShootingOracle::place(double s) const {
  const Vec2d p = curve_.place(s);
  return {p.x(), p.y(), field_(p.x(), p.y()).f};
}

Vec2d ShootingOracle::shoot(double s, double d) const {
  const Vec2d p = curve_.place(s);
  const Height h = field_(p.x(), p.y());
  const Vec3d along = lifted(h, curve_.derivative(s)), normal(-h.fx, -h.fy, 1);
  const Vec3d left = normal.cross(along).normalized();
  const State end = integrate(field_, {p.x(), p.y(), left.x(), left.y()}, d, 24);
  return end.head<2>();
}

double ShootingOracle::parameter_at(double t) const {
  const auto last = static_cast<double>(lengths_.size() - 1);
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(lengths_, t) - lengths_.begin(), 1,
                                                static_cast<std::ptrdiff_t>(lengths_.size()) - 1);
  const auto i = static_cast<std::size_t>(after);
  return (static_cast<double>(i - 1) + (t - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1])) / last;
}

double ShootingOracle::length_at(double s) const {
  const double place = std::clamp(s, 0., 1.) * static_cast<double>(lengths_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), lengths_.size() - 2);
  return lengths_[i] + (place - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
}

std::optional<ShootingOracle::Coordinates> ShootingOracle::solve(const Vec2d& x,
                                                                 const Coordinates& guess) const {
  Vec2d p(parameter_at(guess.t), guess.d);
  for (int i = 0; i < 12; ++i) {
    const Vec2d miss = shoot(p.x(), p.y()) - x;
    if (miss.norm() < 1e-10) return Coordinates{length_at(p.x()), p.y()};
    constexpr double h = 1e-6;
    Eigen::Matrix2d jacobian;
    jacobian.col(0) = (shoot(p.x() + h, p.y()) - shoot(p.x() - h, p.y())) / (2 * h);
    jacobian.col(1) = (shoot(p.x(), p.y() + h) - shoot(p.x(), p.y() - h)) / (2 * h);
    p -= jacobian.inverse() * miss;
    if (!(p.x() > -0.2 && p.x() < 1.2)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace burin::test
