#pragma once
#include <burin/chart/chart.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/oracles/shooting.h"

namespace burin::test {

/// Errors of one coordinate, percent of the radius.
struct Errors {
  std::vector<double> sorted;

  double mean() const {
    return std::accumulate(sorted.begin(), sorted.end(), 0.) / static_cast<double>(sorted.size());
  }
  double p99() const { return sorted[sorted.size() * 99 / 100]; }
};

struct ChartErrors {
  Errors t, d;
};

/// An egg crate of seven radii of 0.3.
inline Height shallow_egg_crate(double x, double y) {
  const double a = 0.12, p = 3, q = 2.5, sx = std::sin(p * x), cx = std::cos(p * x);
  const double sy = std::sin(q * y + 0.4), cy = std::cos(q * y + 0.4);
  return {a * sx * sy,          a * p * cx * sy,     a * q * sx * cy,
          -a * p * p * sx * sy, a * p * q * cx * cy, -a * q * q * sx * sy};
}

inline Height hill_on_saddle(double x, double y) {
  const double e = 0.3 * std::exp(-3 * (x * x + y * y));
  return {0.3 * (x * x - y * y) + e,    0.6 * x - 6 * x * e, -0.6 * y - 6 * y * e,
          0.6 - 6 * e + 36 * x * x * e, 36 * x * y * e,      -0.6 - 6 * e + 36 * y * y * e};
}

/// Turns both ways.
inline PlaneCurve s_curve() {
  return {[](double s) { return Vec2d(-0.8 + 1.6 * s, 0.25 * std::sin(3.5 * s - 1)); },
          [](double s) { return Vec2d(1.6, 0.875 * std::cos(3.5 * s - 1)); }};
}

/// Measures about 2000 nodes of a chart, away from the stroke's ends. place(vertex) returns (x, y) of the
/// vertex's foot point on the smooth surface.
template <class PlaceOf>
ChartErrors errors_of(const Chart& chart, const ShootingOracle& oracle, double radius, const PlaceOf& place) {
  ChartErrors errors;
  const std::size_t stride = std::max<std::size_t>(1, chart.size() / 2000);
  std::size_t unsolved = 0;
  for (std::size_t i = 0; i < chart.size(); i += stride) {
    const auto exact = oracle.solve(place(chart.vertex[i]), {chart.t[i], chart.d[i]});
    if (!exact) {
      ++unsolved;
    } else if (exact->t > radius / 3 && exact->t < oracle.length() - radius / 3) {
      errors.t.sorted.push_back(100 / radius * std::abs(chart.t[i] - exact->t));
      errors.d.sorted.push_back(100 / radius * std::abs(static_cast<double>(chart.d[i]) - exact->d));
    }
  }
  EXPECT_EQ(unsolved, 0U);
  EXPECT_GT(errors.t.sorted.size(), 500U);
  std::ranges::sort(errors.t.sorted);
  std::ranges::sort(errors.d.sorted);
  return errors;
}

}  // namespace burin::test
