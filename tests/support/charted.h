#pragma once
#include <burin/chart/stroke_chart_builder.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/base_surface/surface_levels.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <utility>
#include <vector>

#include "support/traced.h"

namespace burin::test {

/// A surface with everything that charts on its base surface need.
struct Charted {
  explicit Charted(TriangleMesh mesh)
      : surface(make_surface(std::move(mesh))), picker(surface), levels(surface), builder(surface, &levels) {}

  /// Traces the curve of samples near the surface; returns its chart.
  Chart chart(const ChartOptions& options, const std::vector<Vec3d>& samples) {
    builder.begin(options);
    curve = traced(CurveGround(surface, picker, builder.base()), picker, options.radius, samples);
    return builder.draw(curve).sorted();
  }

  /// Traces the curve through the points that rays meet; returns its chart.
  Chart chart(const ChartOptions& options, const std::vector<Ray>& pens) {
    std::vector<Vec3d> samples;
    for (const Ray& pen : pens)
      if (const auto at = picker.pick(pen)) samples.push_back(at->position.cast<double>());
    return chart(options, samples);
  }

  Surface surface;
  Picker picker;
  SurfaceLevels levels;
  StrokeChartBuilder builder;
  SurfaceCurve curve;  ///< curve of the last chart
};

}  // namespace burin::test
