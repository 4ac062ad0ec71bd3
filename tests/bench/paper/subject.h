#pragma once
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/picker.h>

#include <string>

#include "flat_triangle.h"
#include "support/oracles/exact_geodesic.h"

namespace burin::paper {

/// A mesh to draw on.
struct Scene {
  std::string name;
  Surface surface;
  Picker picker;
  int picture_width = 560;  ///< pixels, a third more than the height

  Scene(std::string called, Surface made)
      : name(std::move(called)), surface(std::move(made)), picker(surface) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

/// A stroke with what the figures ask of it.
struct Subject {
  const Scene* scene;
  double radius;  ///< object units
  SurfaceCurve curve;
  Chart chart;
  test::Region region;  ///< the triangles inside the chart that hang together with the stroke
};

Subject make_subject(const Scene& scene, SurfaceCurve curve, double radius);

/// The chart's own (t, d).
Parameterization chart_coordinates(const Subject& subject);

/// The nodes between the stroke's ends and away from the medial axis, where the squared distance has a clear
/// minimum along the stroke, measured by exact geodesics.
std::vector<test::ExactNode> measured_nodes(const Subject& subject);

/// Differences between |v| and the geodesic distance, percent of the radius.
struct DistanceError {
  std::vector<Index> vertices;  ///< of the surface
  std::vector<double> errors;   ///< of these vertices
  double mean() const;
  double max() const;
};
DistanceError distance_error(const Subject& subject, std::span<const test::ExactNode> exact,
                             const Parameterization& places);

/// Share of the region's triangles that the map turns over or flattens, percent.
double flipped(const test::Region& region, const Parameterization& places);

}  // namespace burin::paper
