#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/chart_ground.h>
#include <burin/chart/path/stroke_path.h>
#include <burin/stroke/curve/geodesic_curvature.h>
#include <burin/stroke/curve/surface_curve.h>

#include <cstddef>

namespace burin {

/// The nearest point of one segment of the stroke to some vertex.
struct Foot {
  std::size_t segment = 0;
  float s = 0;  ///< 0..1 along the segment
  Vec3f position = Vec3f::Zero();
  float distance = 0;  ///< object units
};

Foot foot_on(const SurfaceCurve& curve, std::size_t segment, const Vec3f& x);

double arc_length_at(const SurfaceCurve& curve, const Foot& foot);

/// A foot, and the segments that its choice depends on: up to this one.
struct NearestFoot {
  Foot foot;
  std::size_t last_segment = 0;
};

/// Walks along the curve as long as the next segment has a point at right angles to x that is no farther: the
/// segment that found the vertex need not be the one that the vertex projects onto.
NearestFoot nearest_from(const SurfaceCurve& curve, const Foot& start, const Vec3f& x);

/// The frame at a vertex, from its foot on the curve of this path. Curvature and stretch to second order in
/// the distance.
ChartFrame frame_from(const GroundVertex& vertex, const SurfaceCurve& curve,
                      const GeodesicCurvature& curvature, const StrokePath& path, Foot foot);

}  // namespace burin
