// Seeds from stroke segments. Instead of inserting the stroke's points into the neighbour graph (section 4
// of the paper), vertices near the stroke take their coordinates from the nearest point of its segments.
#include <burin/chart/frame_step.h>
#include <burin/chart/seeds.h>
#include <burin/stroke/geodesic_curvature.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// The nearest point of one segment, from points[segment] to the next, to some vertex.
struct Foot {
  std::size_t segment;
  float s;  ///< 0..1 along the segment
  Vec3f position;
  float distance;
};

Foot foot_on(const SurfaceCurve& curve, std::size_t segment, const Vec3f& x) {
  const Vec3f& from = curve.points[segment].at.position;
  const Vec3f& to = curve.points[std::min(segment + 1, curve.points.size() - 1)].at.position;
  const Vec3f chord = to - from;
  const float squared = chord.squaredNorm();
  const float s = squared > 0 ? std::clamp((x - from).dot(chord) / squared, 0.F, 1.F) : 0;
  const Vec3f position = from + s * chord;
  return {segment, s, position, (x - position).norm()};
}

std::size_t segment_count(const SurfaceCurve& curve) {
  return std::max<std::size_t>(curve.points.size(), 2) - 1;
}

/// Walks along the curve as long as the next segment has a point at right angles to x that is no farther: the
/// segment that found the vertex need not be the one that the vertex projects onto.
Foot nearest_from(const SurfaceCurve& curve, Foot foot, const Vec3f& x) {
  for (;;) {
    const bool forward = foot.s == 1 && foot.segment + 1 < segment_count(curve);
    const bool backward = foot.s == 0 && foot.segment > 0;
    if (!forward && !backward) return foot;
    const Foot next = foot_on(curve, forward ? foot.segment + 1 : foot.segment - 1, x);
    const bool passes_joint = forward ? next.s > 0 : next.s < 1;
    // Where the foot moves little, its distance changes by less than a float can tell.
    const float rounding = 4 * std::numeric_limits<float>::epsilon() * foot.distance;
    if (!passes_joint || next.distance > foot.distance + rounding) return foot;
    foot = next;
  }
}

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
    constexpr float steepest = 0.5F;
    if (std::max(std::abs(begin), std::abs(end)) > steepest) return;
    begin_ = begin;
    end_ = end;
  }

  Vec3f position(float s) const { return from_ + s * length_ * along_ + offset(s) * left_; }

  /// Where x projects onto the arc, from a first guess. Slightly beyond 0 and 1 where the joint's wedge is.
  float foot(const Vec3f& x, float s) const {
    if (!(length_ > 0)) return s;
    const float ahead = (x - from_).dot(along_), beside = (x - from_).dot(left_);
    for (int i = 0; i < 2; ++i) s = (ahead + (beside - offset(s)) * slope_at(s)) / length_;
    return std::clamp(s, -0.5F, 1.5F);
  }

 private:
  float slope(const Vec3f& tangent) const {
    const float forward = tangent.dot(along_);
    return forward > 0 ? tangent.dot(left_) / forward : std::numeric_limits<float>::infinity();
  }
  float offset(float s) const { return length_ * s * (1 - s) * (begin_ * (1 - s) - end_ * s); }
  float slope_at(float s) const { return begin_ * (1 - s) * (1 - 3 * s) - end_ * s * (2 - 3 * s); }

  Vec3f from_, along_ = Vec3f::Zero(), left_ = Vec3f::Zero();
  float length_ = 0, begin_ = 0, end_ = 0;  ///< slopes against the chord
};

/// `curvature`: geodesic, of the curve at its points.
Seed seed_at(const Surface& surface, const SurfaceCurve& curve, const std::vector<float>& curvature,
             Foot foot, Index vertex) {
  const std::size_t next = std::min(foot.segment + 1, curve.points.size() - 1);
  const CurvePoint &a = curve.points[foot.segment], &b = curve.points[next];
  const Vec3f normal = ((1 - foot.s) * a.normal + foot.s * b.normal).normalized();
  const bool clamped = (foot.segment == 0 && foot.s == 0) || (next + 1 == curve.points.size() && foot.s == 1);
  if (!clamped) {
    const Arc arc(a, b, normal);
    foot.s = arc.foot(surface.positions[vertex], foot.s);
    foot.position = arc.position(foot.s);
  }
  const Vec3f along = (1 - foot.s) * a.tangent + foot.s * b.tangent;
  const Vec3f flat = along - normal.dot(along) * normal;
  const Vec3f tangent = flat.squaredNorm() > 0 ? Vec3f(flat.normalized()) : a.tangent;
  const auto [step, e1] =
      step_along_edge(foot.position, normal, tangent, surface.positions[vertex], surface.normals[vertex]);

  const bool at_begin = foot.segment == 0 && foot.s == 0;
  const bool at_end = foot.segment + 1 == segment_count(curve) && (foot.s == 1 || curve.points.size() == 1);
  const bool beyond = (at_begin && step.x() < 0) || (at_end && step.x() > 0);
  Seed seed{vertex, foot.distance, {}};
  seed.frame.t =
      a.t + static_cast<double>(foot.s) * (b.t - a.t) + (beyond ? static_cast<double>(step.x()) : 0);
  // Adding 0 makes one zero of both, for comparisons bit by bit.
  seed.frame.d = beyond ? step.y() : std::copysign(step.norm(), step.y()) + 0.0F;
  seed.frame.e1 = e1;

  const float k = (1 - foot.s) * curvature[foot.segment] + foot.s * curvature[next], d = seed.frame.d;
  const float gauss = surface.gauss_curvature[vertex];
  // Beside a bend whose centre is nearer than the seed the coordinates fold, and count as straight.
  if (std::abs(k * d) < 0.5F) {
    seed.frame.curvature = k / (1 - k * d) + gauss * d;
    seed.frame.stretch = 1 - k * d - gauss * d * d / 2;
  }
  return seed;
}

/// The best foot so far of every vertex around the curve's points.
class NearestFeet {
 public:
  NearestFeet(const Surface& surface, const SurfaceCurve& curve, VertexNodes& found)
      : surface_(surface), curve_(curve), found_(found) {
    found_.clear();
  }

  void offer_one_ring(Index triangle, std::size_t segment) {
    for (const Index corner : surface_.triangles[triangle]) {
      for (const Index vertex : surface_.neighbours[corner]) offer(vertex, segment);
    }
  }
  const std::vector<Foot>& feet() const { return feet_; }

 private:
  void offer(Index vertex, std::size_t segment) {
    const Foot foot = foot_on(curve_, segment, surface_.positions[vertex]);
    const Index known = found_.find(vertex);
    if (known == no_index) {
      found_.insert(vertex);
      feet_.push_back(foot);
    } else if (foot.distance < feet_[known].distance) {
      feet_[known] = foot;
    }
  }

  const Surface& surface_;
  const SurfaceCurve& curve_;
  VertexNodes& found_;
  std::vector<Foot> feet_;  ///< [node of found_]
};

}  // namespace

std::vector<Seed> find_seeds(const Surface& surface, const SurfaceCurve& curve, double radius,
                             VertexNodes& found) {
  NearestFeet nearest(surface, curve, found);
  for (std::size_t segment = 0; segment < segment_count(curve); ++segment) {
    const Index from = curve.points[segment].at.triangle;
    const Index to = curve.points[std::min(segment + 1, curve.points.size() - 1)].at.triangle;
    nearest.offer_one_ring(from, segment);
    if (to != from) nearest.offer_one_ring(to, segment);
  }

  const std::vector<float> curvature = geodesic_curvature(curve, radius * 0.4);
  std::vector<Seed> seeds;
  seeds.reserve(found.size());
  for (Index node = 0; node < found.size(); ++node) {
    const Index vertex = found.vertex(node);
    const Foot foot = nearest_from(curve, nearest.feet()[node], surface.positions[vertex]);
    seeds.push_back(seed_at(surface, curve, curvature, foot, vertex));
  }
  return seeds;
}

}  // namespace burin
