// Compares |d| of charts over base surfaces of real scans with exact geodesics of the low-passed scan,
// whose vertices are moved onto the base surface.
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "support/charted.h"
#include "support/gentle_stroke.h"
#include "support/oracles/exact_geodesic.h"
#include "support/shared_data.h"

namespace burin {
namespace {

/// The scan with the vertices near the chart on the base surface that the builder runs on.
Surface low_passed(test::Charted& scan, const Chart& chart) {
  Surface smooth = scan.surface;
  BaseSurface& base = *scan.builder.base();
  for (const Index of_chart : chart.vertex)
    for (const Index triangle : scan.surface.incident[of_chart])
      for (const Index vertex : scan.surface.triangles[triangle])
        smooth.positions[vertex] =
            base.project(base.node_of(vertex), scan.surface.positions[vertex]).position;
  return smooth;
}

/// The curve with its points in the triangles of this surface.
SurfaceCurve on_triangles(SurfaceCurve curve, const Picker& picker, double radius) {
  for (CurvePoint& point : curve.points)
    if (const auto at = picker.closest(point.at.position, static_cast<float>(radius))) point.at = *at;
  return curve;
}

/// Nodes in bands across the stroke, a tenth of a radius wide and one radius apart, away from its ends.
std::vector<std::size_t> banded_nodes(const Chart& chart, double radius) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const double t = chart.t[i];
    if (t > radius && t < chart.length - radius && std::fmod(t, radius) < radius / 10) nodes.push_back(i);
  }
  return nodes;
}

/// Percent of the radius, of nodes away from focal points and the medial axis.
std::vector<double> d_errors(const Surface& surface, const SurfaceCurve& curve, const Chart& chart,
                             double radius) {
  std::vector<double> errors;
  for (const test::ExactNode& exact :
       test::exact_nodes(surface, curve, chart, radius, banded_nodes(chart, radius)))
    if (exact.convexity >= 0.3)
      errors.push_back(100 / radius *
                       std::abs(std::abs(static_cast<double>(chart.d[exact.node])) - exact.distance));
  return errors;
}

struct Figures {
  double mean, p99;
};

Figures mean_and_p99(std::vector<double> errors) {
  std::ranges::sort(errors);
  double sum = 0;
  for (const double error : errors) sum += error;
  return {sum / static_cast<double>(errors.size()), errors[errors.size() * 99 / 100]};
}

class BaseScan : public testing::TestWithParam<const char*> {};

TEST_P(BaseScan, IsChartedByTheDistancesOfTheLowPassedScan) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/") + GetParam());
  test::Charted scan(triangulate(read_mesh(file)));
  const double radius = 20 * test::mean_edge(scan.surface);
  const std::uint32_t seed = 31;
  std::cout << "seed " << seed << "\n";
  std::vector<double> own_scale, all_relief, own_scale_on_scan;
  for (std::uint32_t tries = 0, strokes = 0; strokes < 4 && tries < 100; ++tries) {
    std::mt19937 random(seed + tries);
    const SurfaceCurve curve = test::gentle_stroke(scan.surface, scan.picker, radius, 5 * radius, random);
    if (curve.length() < 4 * radius) continue;
    const Chart felt = scan.builder.chart(curve, {.radius = radius});
    std::vector<Vec3d> samples;
    for (const CurvePoint& point : curve.points)
      if (samples.empty() || point.t > 0.2 * radius * static_cast<double>(samples.size()))
        samples.push_back(point.at.position.cast<double>());
    const Chart chart = scan.chart({.radius = radius, .follow = 0}, samples);
    ASSERT_NE(scan.builder.base(), nullptr);
    const Surface smooth = low_passed(scan, chart);
    const Picker picker(smooth);
    const auto append = [](std::vector<double>& to, const std::vector<double>& errors) {
      to.insert(to.end(), errors.begin(), errors.end());
    };
    append(own_scale, d_errors(smooth, on_triangles(scan.curve, picker, radius), chart, radius));
    append(own_scale_on_scan,
           d_errors(scan.surface, on_triangles(scan.curve, scan.picker, radius), chart, radius));
    append(all_relief, d_errors(scan.surface, curve, felt, radius));
    ++strokes;
  }
  ASSERT_GT(own_scale.size(), 400U);
  const Figures own = mean_and_p99(own_scale), all = mean_and_p99(all_relief),
                on_scan = mean_and_p99(own_scale_on_scan);
  std::cout << GetParam() << ": |d| at the brush's own scale, against the low-passed scan: mean " << own.mean
            << " p99 " << own.p99 << "; against the scan itself: mean " << on_scan.mean << " p99 "
            << on_scan.p99 << "; following all relief, against the scan itself: mean " << all.mean << " p99 "
            << all.p99 << " % of the radius; " << own_scale.size() << " nodes\n";
  // The two differ by several percent where the scan has folds narrower than the brush.
  EXPECT_LE(own.mean, 0.5);
  EXPECT_LE(own.p99, 7);
}

INSTANTIATE_TEST_SUITE_P(Shared, BaseScan,
                         testing::Values("stanford-bunny.obj", "nefertiti-lowres.obj", "dragon_vrip.ply"),
                         [](const auto& scan) { return test::test_name_of(scan.param); });

}  // namespace
}  // namespace burin
