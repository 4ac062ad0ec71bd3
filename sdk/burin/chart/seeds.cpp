// Seeds from stroke segments. Instead of inserting the stroke's points into the neighbour graph (section 4
// of the paper), vertices near the stroke take their coordinates from the nearest point of its segments.
#include <burin/chart/frame_step.h>
#include <burin/chart/seeds.h>

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

Seed seed_at(const Surface& surface, const SurfaceCurve& curve, const Foot& foot, Index vertex) {
  const CurvePoint& a = curve.points[foot.segment];
  const CurvePoint& b = curve.points[std::min(foot.segment + 1, curve.points.size() - 1)];
  const Vec3f normal = ((1 - foot.s) * a.normal + foot.s * b.normal).normalized();
  const Vec3f along = (1 - foot.s) * a.tangent + foot.s * b.tangent;
  const Vec3f flat = along - normal.dot(along) * normal;
  const Vec3f tangent = flat.squaredNorm() > 0 ? Vec3f(flat.normalized()) : a.tangent;
  const auto [step, e1] =
      step_along_edge(foot.position, normal, tangent, surface.positions[vertex], surface.normals[vertex]);

  const bool at_begin = foot.segment == 0 && foot.s == 0;
  const bool at_end = foot.segment + 1 == segment_count(curve) && (foot.s == 1 || curve.points.size() == 1);
  const bool beyond = (at_begin && step.x() < 0) || (at_end && step.x() > 0);
  const double t = a.t + static_cast<double>(foot.s) * (b.t - a.t);
  // Adding 0 makes one zero of both, for comparisons bit by bit.
  return {vertex,
          foot.distance,
          {beyond ? t + static_cast<double>(step.x()) : t,
           beyond ? step.y() : std::copysign(step.norm(), step.y()) + 0.0F, e1}};
}

/// The best foot so far of every vertex around the curve's points.
class NearestFeet {
 public:
  NearestFeet(const Surface& surface, const SurfaceCurve& curve, VertexNodes& found)
      : surface_(surface), curve_(curve), found_(found) {
    found_.clear();
  }

  void offer_one_ring(const SurfacePoint& at, std::size_t segment) {
    for (const Index corner : at.corners) {
      offer(corner, segment);
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

std::vector<Seed> find_seeds(const Surface& surface, const SurfaceCurve& curve, VertexNodes& found) {
  NearestFeet nearest(surface, curve, found);
  for (std::size_t segment = 0; segment < segment_count(curve); ++segment) {
    const SurfacePoint& from = curve.points[segment].at;
    const SurfacePoint& to = curve.points[std::min(segment + 1, curve.points.size() - 1)].at;
    nearest.offer_one_ring(from, segment);
    if (to.corners != from.corners) nearest.offer_one_ring(to, segment);
  }

  std::vector<Seed> seeds;
  seeds.reserve(found.size());
  for (Index node = 0; node < found.size(); ++node) {
    const Index vertex = found.vertex(node);
    const Foot foot = nearest_from(curve, nearest.feet()[node], surface.positions[vertex]);
    seeds.push_back(seed_at(surface, curve, foot, vertex));
  }
  return seeds;
}

}  // namespace burin
