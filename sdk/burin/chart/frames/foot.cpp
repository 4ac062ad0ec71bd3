// Computes the foot of a vertex on the stroke, and from it the vertex's Fermi coordinates to second order in
// the distance. The nearest segment is found by walking along the polyline; then Newton's method finds the
// foot on a cubic arc through the segment's ends, in at most four steps.
#include <burin/base/segment.h>
#include <burin/chart/frames/float_rounding.h>
#include <burin/chart/frames/foot.h>
#include <burin/chart/frames/frame_step.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

bool at_begin(const SurfaceCurve& curve, const Foot& foot) {
  return !curve.closed && foot.segment == 0 && foot.s == 0;
}

bool at_end(const SurfaceCurve& curve, const Foot& foot) {
  return !curve.closed && foot.segment + 1 == curve.segment_count() &&
         (foot.s == 1 || curve.points.size() == 1);
}

/// A seed that does not stand at right angles to its foot by more than this (sine) is beside a corner.
constexpr float widest_miss = 0.15F;

/// Fermi coordinates have an infinite one around corners.
constexpr float stretch_around_corners = 10;

/// The curve between two points beside the chord between them, as its tangents tell: a cubic in the tangent
/// plane. Tangents far from the chord are a corner, and the chord stays straight.
class Arc {
 public:
  Arc(const CurvePoint& a, const CurvePoint& b, const Vec3f& normal) : from_(a.at.position) {
    const Vec3f chord = b.at.position - a.at.position;
    length_ = chord.norm();
    if (!(length_ > 0)) return;
    along_ = chord / length_;
    left_ = normal.cross(along_);
    const float begin = slope(a.tangent), end = slope(b.tangent);
    constexpr float steepest = 0.5F, sharp = 0.2F;
    // Tangents that both go backward have a difference that is not a number.
    sharp_ = !(std::abs(end - begin) <= sharp);
    if (std::max(std::abs(begin), std::abs(end)) > steepest) return;
    begin_ = begin;
    end_ = end;
  }

  /// The length of the chord, object units.
  float length() const { return length_; }

  /// Whether the stroke turns here by more than strokes do from point to point.
  bool is_sharp() const { return sharp_; }

  Vec3f position(float s) const { return from_ + s * length_ * along_ + offset(s) * left_; }

  /// Where x projects onto the arc, from a first guess; 0..1.
  float foot(const Vec3f& x, float s) const {
    if (!(length_ > 0)) return s;
    const float ahead = (x - from_).dot(along_) / length_, beside = (x - from_).dot(left_) / length_;
    const auto squared_distance = [&](float at) {
      const float u = ahead - at, v = beside - offset(at) / length_;
      return u * u + v * v;
    };
    for (int i = 0; i < 4; ++i) {
      const float slope = slope_at(s), left = beside - offset(s) / length_;
      // Newton's method, where the arc does not bend around x.
      const float steepness = 1 + slope * slope - left * bend_at(s);
      constexpr float least_steepness = 0.1F;
      const float step = (ahead - s + left * slope) / std::max(steepness, least_steepness);
      const float next = std::clamp(s + step, 0.F, 1.F);
      // Farther off by more than rounding.
      if (squared_distance(next) > 1.0001F * squared_distance(s)) break;
      s = next;
    }
    return s;
  }

 private:
  float slope(const Vec3f& tangent) const {
    const float forward = tangent.dot(along_);
    return forward > 0 ? tangent.dot(left_) / forward : std::numeric_limits<float>::infinity();
  }
  float offset(float s) const { return length_ * s * (1 - s) * (begin_ * (1 - s) - end_ * s); }
  float slope_at(float s) const { return begin_ * (1 - s) * (1 - 3 * s) - end_ * s * (2 - 3 * s); }
  float bend_at(float s) const { return begin_ * (6 * s - 4) + end_ * (6 * s - 2); }

  Vec3f from_, along_ = Vec3f::Zero(), left_ = Vec3f::Zero();
  float length_ = 0, begin_ = 0, end_ = 0;  ///< slopes against the chord
  bool sharp_ = false;
};

}  // namespace

Foot foot_on(const SurfaceCurve& curve, std::size_t segment, const Vec3f& x) {
  const Vec3f &from = curve.points[segment].at.position, &to = curve.points[curve.next(segment)].at.position;
  const float s = share_on_segment(from, to, x);
  const Vec3f position = from + s * (to - from);
  return {segment, s, position, (x - position).norm()};
}

double arc_length_at(const SurfaceCurve& curve, const Foot& foot) {
  const double from = curve.points[foot.segment].t;
  return from + static_cast<double>(foot.s) * (curve.segment_end(foot.segment) - from);
}

NearestFoot nearest_from(const SurfaceCurve& curve, const Foot& start, const Vec3f& x) {
  const std::size_t count = curve.segment_count();
  Foot foot = start;
  std::size_t last_segment = foot.segment;
  for (std::size_t walked = 0; walked < count; ++walked) {
    const bool forward = foot.s == 1 && !at_end(curve, foot);
    const bool backward = foot.s == 0 && !at_begin(curve, foot);
    if (!forward && !backward) break;
    const Foot next = foot_on(curve, (foot.segment + (forward ? 1 : count - 1)) % count, x);
    last_segment = std::max(last_segment, next.segment);
    const bool passes_joint = forward ? next.s > 0 : next.s < 1;
    // Where the foot moves little, its distance changes by less than floats of this size can tell.
    const float rounding = float_rounding(foot.distance + x.cwiseAbs().maxCoeff());
    if (!passes_joint || next.distance > foot.distance + rounding) break;
    foot = next;
  }
  // The foot on the arcs beside the polyline may lie on the next one.
  return {foot, std::max(last_segment, std::min(foot.segment + 1, count - 1))};
}

namespace {

/// A foot on the arc between two points of the curve.
struct ArcFoot {
  Foot foot;
  bool at_corner;  ///< the stroke turns sharply there, nearer to x than which no coordinates are its own
};

ArcFoot on_arc(const SurfaceCurve& curve, Foot foot, const Vec3f& x) {
  const CurvePoint &a = curve.points[foot.segment], &b = curve.points[curve.next(foot.segment)];
  const Arc arc(a, b, ((1 - foot.s) * a.normal + foot.s * b.normal).normalized());
  foot.s = arc.foot(x, foot.s);
  foot.position = arc.position(foot.s);
  foot.distance = (x - foot.position).norm();
  return {foot, arc.is_sharp() && foot.distance > arc.length()};
}

/// The foot on the arc of the segment or, where that ends in a joint, on the next one: the same from
/// whichever of both it is looked for.
ArcFoot on_arcs(const SurfaceCurve& curve, const Foot& start, const Vec3f& x) {
  ArcFoot own = on_arc(curve, start, x);
  const std::size_t count = curve.segment_count();
  const bool forward = own.foot.s == 1 && !at_end(curve, own.foot);
  const bool backward = own.foot.s == 0 && !at_begin(curve, own.foot);
  if (!forward && !backward) return own;
  Foot joint{(own.foot.segment + (forward ? 1 : count - 1)) % count, forward ? 0.F : 1.F, own.foot.position,
             own.foot.distance};
  ArcFoot other = on_arc(curve, joint, x);
  if (other.foot.s != joint.s) return other;
  return {own.foot, own.at_corner || other.at_corner};
}

}  // namespace

ChartFrame frame_from(const GroundVertex& vertex, const SurfaceCurve& curve,
                      const GeodesicCurvature& curvature, const StrokePath& path, Foot foot) {
  const bool begin = at_begin(curve, foot), end = at_end(curve, foot);
  bool at_corner = false;
  if (!begin && !end) {
    const ArcFoot on_arc = on_arcs(curve, foot, vertex.position);
    foot = on_arc.foot;
    at_corner = on_arc.at_corner;
  }
  const std::size_t next = curve.next(foot.segment);
  const CurvePoint &a = curve.points[foot.segment], &b = curve.points[next];
  const Vec3f normal = ((1 - foot.s) * a.normal + foot.s * b.normal).normalized();
  const Vec3f along = (1 - foot.s) * a.tangent + foot.s * b.tangent;
  const Vec3f flat = along - normal.dot(along) * normal;
  const Vec3f tangent = flat.squaredNorm() > 0 ? Vec3f(flat.normalized()) : a.tangent;
  const auto [step, e1] = step_along_edge(foot.position, normal, tangent, vertex.position, vertex.normal);

  const bool beyond = (begin && step.x() < 0) || (end && step.x() > 0);
  ChartFrame frame;
  frame.t = arc_length_at(curve, foot) + (beyond ? static_cast<double>(step.x()) : 0);
  // Adding 0 makes one zero of both, for comparisons bit by bit.
  frame.d = beyond ? step.y() : std::copysign(step.norm(), step.y()) + 0.0F;
  frame.e1 = e1;

  // Around the outside of a corner lines of constant d are circles, along which t stands still.
  if (at_corner && frame.d != 0 && std::abs(step.x()) > widest_miss * step.norm()) {
    const Vec3f e2 = vertex.normal.cross(e1);
    frame.e1 = (step.y() * e1 - step.x() * e2) / frame.d;
    frame.curvature = -1 / frame.d;
    frame.stretch = stretch_around_corners;
    return frame;
  }
  const float gauss = vertex.gauss_curvature;
  if (const DistanceRay ray = path.ray(frame.t, static_cast<double>(frame.d)); ray.from_end()) {
    const auto [of_circles, stretch] = shape_around_end(ray.length, gauss);
    frame.curvature = stretch > least_stretch ? of_circles : 0;
    frame.stretch = std::max(stretch, least_stretch);
    return frame;
  }
  // Where it does not end round the stroke goes on as a geodesic.
  const float k = beyond ? 0 : (1 - foot.s) * curvature[foot.segment] + foot.s * curvature[next];
  const float d = frame.d;
  // On the inside of a bend whose centre is nearer than the seed the coordinates fold, and count as straight.
  if (k * d < 0.5F) {
    frame.curvature = k / (1 - k * d) + gauss * d;
    frame.stretch = std::max(1 - k * d - gauss * d * d / 2, least_stretch);
  }
  return frame;
}

}  // namespace burin
