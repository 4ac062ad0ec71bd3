#pragma once
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/picker.h>
#include <burin/surface/point_set.h>
#include <burin/surface/surface.h>

#include <utility>

namespace burin::test {

/// A mesh or a point set with everything that charts on its vertices need.
struct Scene {
  explicit Scene(TriangleMesh mesh) : Scene(make_surface(std::move(mesh))) {}
  explicit Scene(const PointSet& points) : Scene(make_point_surface(points)) {}

  Surface surface;
  Picker picker;
  StrokeChartBuilder builder;

 private:
  explicit Scene(Surface made) : surface(std::move(made)), picker(surface), builder(surface) {}
};

}  // namespace burin::test
