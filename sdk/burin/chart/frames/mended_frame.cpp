// Frames that a front carries on sideways past a corner of the stroke, its end, or a bend's centre tell of a
// stroke that goes on straight, and so of distances that are too short. They are held against the stroke at
// the arc length that they tell, and taken from the stroke anew where they are false.
#include <burin/chart/frames/foot.h>
#include <burin/chart/frames/mended_frame.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>

namespace burin {
namespace {

/// Over this excess, in radii, false frames go over into those from the stroke.
constexpr double blended = 0.007;

/// Surfaces that have turned by more than this between a vertex and its foot are not straight in between.
constexpr float least_cosine = 0.5F;

ChartFrame between(const ChartFrame& a, const ChartFrame& b, double share, const Vec3f& normal) {
  const auto s = static_cast<float>(share);
  return {.t = a.t + share * (b.t - a.t),
          .d = a.d + s * (b.d - a.d),
          .e1 = unit_tangent((1 - s) * a.e1 + s * b.e1, normal),
          .curvature = a.curvature + s * (b.curvature - a.curvature),
          .stretch = a.stretch + s * (b.stretch - a.stretch)};
}

}  // namespace

MendedFrame mended_frame(const FrontStroke& stroke, const GroundVertex& vertex, const ChartFrame& frame) {
  const double excess = stroke.path.excess(frame.t, static_cast<double>(frame.d), vertex.position);
  // First order is the published method, without mending.
  if (stroke.order == 1 || !(excess > stroke.path.doubt())) return {frame, frame.t};
  const Foot start = foot_on(stroke.curve, segment_at(stroke.curve, frame.t), vertex.position);
  const auto [foot, last_segment] = nearest_from(stroke.curve, start, vertex.position);
  const double depends_to =
      std::max(frame.t, stroke.curve.segment_end(last_segment) + seen_by_curvature * stroke.radius);
  // Through a thin part or across a fold the straight line is no way on the surface.
  if (vertex.normal.dot(stroke.curve.points[foot.segment].normal) < least_cosine) return {frame, depends_to};
  ChartFrame of_stroke = frame_from(vertex, stroke.curve, stroke.curvature, stroke.path, foot);
  of_stroke.t = stroke.samples.unwrapped(of_stroke.t, frame.t);
  const double share = (excess - stroke.path.doubt()) / (blended * stroke.radius);
  const bool other_side = of_stroke.d * frame.d < 0;
  return {share < 1 && !other_side ? between(frame, of_stroke, share, vertex.normal) : of_stroke, depends_to};
}

}  // namespace burin
