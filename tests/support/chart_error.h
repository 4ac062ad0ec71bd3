#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burin::test {

/// The greatest and mean absolute errors of t and d over nodes of a chart, as shares of the radius.
struct ChartError {
  double t_mean = 0, t_max = 0, d_mean = 0, d_max = 0;
  std::size_t count = 0;
};

struct Coordinates {
  double t, d;
};

/// Measures the errors of a chart. exact(position) returns the true Coordinates of a position on the surface.
/// Nodes whose t is closer than `margin` to the stroke's ends, or beyond them, are left out.
template <class Exact>
ChartError error_against(const Surface& surface, const Chart& chart, double length, double radius,
                         double margin, const Exact& exact) {
  ChartError error;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Coordinates truth = exact(Vec3d(surface.positions[chart.vertex[i]].template cast<double>()));
    if (truth.t < margin || truth.t > length - margin) continue;
    const double t = std::abs(chart.t[i] - truth.t) / radius;
    const double d = std::abs(static_cast<double>(chart.d[i]) - truth.d) / radius;
    error.t_mean += t;
    error.d_mean += d;
    error.t_max = std::max(error.t_max, t);
    error.d_max = std::max(error.d_max, d);
    ++error.count;
  }
  error.t_mean /= static_cast<double>(error.count);
  error.d_mean /= static_cast<double>(error.count);
  return error;
}

}  // namespace burin::test
