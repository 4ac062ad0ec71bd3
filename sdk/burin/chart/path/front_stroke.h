#pragma once
#include <burin/chart/path/stroke_path.h>
#include <burin/chart/path/stroke_samples.h>
#include <burin/stroke/curve/geodesic_curvature.h>
#include <burin/stroke/curve/surface_curve.h>

namespace burin {

/// A stroke's curvature at some place may depend on as much of it beyond, in radii: the window over which it
/// is estimated, and a point of the curve more.
inline constexpr double seen_by_curvature = 0.75;

/// The stroke of a front, and what is known of it. All parts of the front share and read it.
struct FrontStroke {
  double radius = 0;  ///< half width of the stroke at width 1, object units
  int order = 2;
  Extensions extensions;
  SurfaceCurve curve;
  StrokeSamples samples;
  StrokePath path;
  GeodesicCurvature curvature;
};

}  // namespace burin
