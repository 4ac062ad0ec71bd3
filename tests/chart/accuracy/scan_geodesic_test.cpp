// Compares |d| of charts on real scans with exact geodesics of the polyhedron.
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "support/gentle_stroke.h"
#include "support/oracles/exact_geodesic.h"
#include "support/shared_data.h"

namespace burin {
namespace {

/// Error statistics, in percent of the radius.
struct ErrorFigures {
  double mean, p99, max;
};

ErrorFigures figures(std::vector<double> errors) {
  std::ranges::sort(errors);
  double sum = 0;
  for (const double error : errors) sum += error;
  return {sum / static_cast<double>(errors.size()), errors[errors.size() * 99 / 100], errors.back()};
}

std::ostream& operator<<(std::ostream& out, const ErrorFigures& error) {
  return out << "mean " << error.mean << " p99 " << error.p99 << " max " << error.max;
}

struct NodeError {
  double d, t;  ///< percent of the radius
};

struct Measured {
  std::map<std::pair<int, Index>, NodeError> errors;  ///< [stroke and vertex]
  std::size_t left_out = 0;  ///< near the medial axis, or t wrong by a fifth of the radius
};

/// Keeps the nodes that all have.
void keep_common(std::vector<Measured>& all) {
  for (Measured& measured : all) {
    std::erase_if(measured.errors, [&](const auto& node) {
      return std::ranges::any_of(all,
                                 [&](const Measured& other) { return !other.errors.contains(node.first); });
    });
  }
}

ErrorFigures figures(const Measured& measured, double NodeError::*coordinate) {
  std::vector<double> errors;
  for (const auto& [node, error] : measured.errors) errors.push_back(error.*coordinate);
  return figures(std::move(errors));
}

/// Nodes in bands across the stroke, a tenth of a radius wide and one radius apart, from one radius after its
/// begin to one before its end.
std::vector<std::size_t> banded_nodes(const Chart& chart, double length, double radius) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double t = chart.t[i];
    if (t > radius && t < length - radius && std::fmod(t, radius) < radius / 10) nodes.push_back(i);
  }
  return nodes;
}

/// Measures the nodes of a chart. Nodes near focal points and the medial axis, where the squared distance
/// along the stroke has no single, clear minimum, are left out.
void measure(const Surface& surface, int stroke, const SurfaceCurve& curve, const Chart& chart, double radius,
             Measured& measured) {
  constexpr double clear = 0.3;
  const auto nodes = banded_nodes(chart, curve.length(), radius);
  measured.left_out += nodes.size();
  for (const test::ExactNode& exact : test::exact_nodes(surface, curve, chart, radius, nodes)) {
    if (exact.convexity < clear) continue;
    const double d = std::abs(static_cast<double>(chart.d[exact.node]));
    measured.errors[{stroke, chart.vertex[exact.node]}] = {
        100 / radius * std::abs(d - exact.distance), 100 / radius * std::abs(chart.t[exact.node] - exact.t)};
    --measured.left_out;
  }
}

struct GeodesicScan {
  const char* file;
  ErrorFigures limit;  ///< of d
};
std::ostream& operator<<(std::ostream& out, const GeodesicScan& scan) { return out << scan.file; }

class ScanGeodesic : public testing::TestWithParam<GeodesicScan> {
 protected:
  static constexpr int strokes = 8;

  /// Measures the same strokes with each of the options, which must share the radius.
  static std::vector<Measured> measure_strokes(const Surface& surface,
                                               const std::vector<ChartOptions>& options) {
    const std::uint32_t seed = 31;
    std::cout << "seed " << seed << "\n";
    const Picker picker(surface);
    StrokeChartBuilder builder(surface);
    const double radius = options.front().radius;
    std::vector<Measured> all(options.size());
    for (int stroke = 0, tries = 0; stroke < strokes && tries < 200; ++tries) {
      std::mt19937 random(seed + static_cast<std::uint32_t>(tries));
      const SurfaceCurve curve = test::gentle_stroke(surface, picker, radius, 5 * radius, random);
      if (curve.length() < 4 * radius) continue;
      for (std::size_t i = 0; i < all.size(); ++i)
        measure(surface, stroke, curve, builder.chart(curve, options[i]), radius, all[i]);
      ++stroke;
    }
    keep_common(all);
    return all;
  }
};

void expect_no_worse(const ErrorFigures& error, const ErrorFigures& limit) {
  EXPECT_LE(error.mean, limit.mean);
  EXPECT_LE(error.p99, limit.p99);
  EXPECT_LE(error.max, limit.max);
}

// Later options are expected to be better than earlier ones.
TEST_P(ScanGeodesic, IsTheDistanceOfTheChart) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/") + GetParam().file);
  const Surface surface = make_surface(triangulate(read_mesh(file)));
  const double radius = 20 * test::mean_edge(surface);
  const std::vector<Measured> all =
      measure_strokes(surface, {{radius, Cap::round, 1}, {radius, Cap::round, 2}});
  for (const Measured& measured : all) {
    ASSERT_GT(measured.errors.size(), 800U);
    EXPECT_LT(measured.left_out, measured.errors.size() / 3);
    const ErrorFigures d = figures(measured, &NodeError::d);
    std::cout << GetParam().file << ": d " << d << ", t " << figures(measured, &NodeError::t)
              << " % of the radius; " << measured.errors.size() << " nodes, " << measured.left_out
              << " left out\n";
    expect_no_worse(d, figures(all.front(), &NodeError::d));
  }
  expect_no_worse(figures(all.back(), &NodeError::d), GetParam().limit);
}

INSTANTIATE_TEST_SUITE_P(Shared, ScanGeodesic,
                         testing::Values(GeodesicScan{"stanford-bunny.obj", {0.1, 0.8, 3}},
                                         GeodesicScan{"nefertiti-lowres.obj", {0.12, 1.5, 6}},
                                         GeodesicScan{"dragon_vrip.ply", {0.06, 0.8, 2}}),
                         [](const auto& scan) { return test::test_name_of(scan.param.file); });

}  // namespace
}  // namespace burin
