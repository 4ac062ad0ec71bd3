#pragma once
#include <burin/chart/frames/circle_step.h>
#include <burin/chart/front/front_node.h>
#include <burin/chart/path/distance_ray.h>
#include <burin/chart/path/stroke_path.h>

#include <algorithm>
#include <cmath>

namespace burin {

/// By how much a frame tells of less than the g of its node, beyond doubt; >= 0, object units.
inline float shortfall_of(const FrontNode& q, const StrokePath& path) {
  const double told = path.chart_distance(q.frame.t, static_cast<double>(q.frame.d));
  return std::max(q.g() - static_cast<float>(told + 2 * path.doubt()), 0.F);
}

/// Share of its length by which g rises along a way at least.
inline constexpr float least_progress = 0.3F;

/// The g to which a way of this length leads on from g, by its end's told distance from the stroke. False
/// frames tell of too short distances. So what they are short of stays with those that follow from them, and
/// no way is free: where surfaces are rough or fold, coordinates turn at times, and the front would else run
/// along where the distance stands still or falls. A true front comes by a way on which it rises by most of
/// an edge. `length`: of what of the way is doubtful.
inline float distance_along(float g, float shortfall, float length, float told) {
  const float whole = told + shortfall, slow = g + least_progress * length;
  const float distance = whole < slow ? slow + (slow - whole) / 2 : whole;
  // Edges too short to tell in floats still lead downwind, or what is upwind would depend on the order.
  return distance > g ? distance : std::nextafter(g, unreached);
}

/// A node that leads on to its neighbours, and where its frame places them.
class Leader {
 public:
  /// The path must outlive the object.
  Leader(const FrontNode& q, const StrokePath& path)
      : path_(&path),
        position_(q.position),
        e1_(q.frame.e1),
        e2_(q.normal.cross(q.frame.e1)),
        t_(q.frame.t),
        d_(q.frame.d),
        curvature_(q.frame.curvature),
        inverse_stretch_(1 / q.frame.stretch),
        ray_(path.ray(q.frame.t, static_cast<double>(q.frame.d))),
        g_(q.g()),
        shortfall_(shortfall_of(q, path)) {}

  struct Way {
    float g;                 ///< distance from the stroke at the end of the way
    double least_t, most_t;  ///< of the arc lengths there and at the node
    float length;            ///< of the edge, object units
  };

  /// Whether the way to x may end at this g or less; if not there is no need to follow it.
  bool may_reach(const Vec3f& x, float g) const { return g_ + least_progress * (x - position_).norm() <= g; }

  /// The way to x. Beside the stroke lines of constant d are taken for circles; the edge is taken with its
  /// length in the tangent plane of the node.
  Way to(const Vec3f& x) const {
    const Vec3f chord = x - position_;
    const float ahead = chord.dot(e1_), beside = chord.dot(e2_);
    const float length = chord.norm(), flat = std::sqrt(ahead * ahead + beside * beside);
    const float scale = flat > 0 ? length / flat : 0;
    const Vec2f change = step(scale * ahead, scale * beside);
    const double t = t_ + static_cast<double>(change.x());
    const auto told = static_cast<float>(path_->distance(t, static_cast<double>(d_ + change.y()), x));
    return {distance_along(g_, shortfall_, length, told), std::min(t, t_), std::max(t, t_), length};
  }

 private:
  /// What a step (u, v) adds to t and d.
  Vec2f step(float u, float v) const {
    if (ray_.from_end()) return ray_step(ray_, curvature_, inverse_stretch_, u, v);
    const CircleStep step = circle_step(u, v, curvature_, d_);
    return {step.along * inverse_stretch_, step.across};
  }

  const StrokePath* path_;
  Vec3f position_, e1_, e2_;
  double t_;
  float d_, curvature_, inverse_stretch_;
  DistanceRay ray_;
  float g_, shortfall_;
};

}  // namespace burin
