// Projects picks and positions onto the surface itself or onto its base surface. On the base surface a few
// Newton iterations find the point whose tangent plane the ray or the position's normal line meets; each
// costs one projection, independent of the size of the surface.
#include <burin/stroke/curve/curve_ground.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/topology/chord_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {

CurveGround::Point CurveGround::point(const SurfacePoint& at) const {
  if (!base_) return {at, normal_at(*surface_, at), at};
  Point point = on_base(base_->node_of(at.corners[0]), at.position);
  point.on_surface = at;
  return point;
}

std::optional<CurveGround::Point> CurveGround::pick(const Ray& ray) const {
  const std::optional<SurfacePoint> at = picker_->pick(ray);
  if (!at) return {};
  constexpr float flattest = 0.3F;  // sine of the angle between ray and base surface
  const Vec3f direction = ray.direction.stableNormalized();
  return settled(*at, [&](const Point& point) -> Vec3f {
    const float slope = direction.dot(point.normal);
    const float below = (point.at.position - at->position).dot(point.normal);
    return at->position + below / std::copysign(std::max(std::abs(slope), flattest), slope) * direction;
  });
}

std::optional<CurveGround::Point> CurveGround::closest(const Vec3f& position, float reach) const {
  const std::optional<SurfacePoint> at = picker_->closest(position, reach);
  if (!at) return {};
  return settled(*at, [&](const Point& point) -> Vec3f {
    return position - (position - point.at.position).dot(point.normal) * point.normal;
  });
}

/// Newton's method: on_plane(point) is the solution on the tangent plane at an estimate, and its projection
/// onto the base surface is a better estimate. The method starts at the projection of `at`, and returns that
/// projection if an iterate goes farther than 8 spacings from it. The surface itself needs no iteration.
template <class OnPlane>
CurveGround::Point CurveGround::settled(const SurfacePoint& at, const OnPlane& on_plane) const {
  constexpr int rounds = 3;
  constexpr double farthest = 8;  // spacings
  Point foot = this->point(at);
  if (!base_) return foot;
  Point point = foot;
  for (int round = 0; round < rounds; ++round) {
    point = on_base(point.at.corners[0], on_plane(point));
    const auto off = static_cast<double>((point.at.position - foot.at.position).norm());
    if (!(off <= farthest * base_->spacing())) return foot;
  }
  point.on_surface = at;
  return point;
}

namespace {

/// Whether the ground is within a quarter of the chord's length of three points of the chord. Calls
/// is_near(point, reach) for the points in the order along the chord.
template <class IsNear>
bool runs_near(const Vec3f& from, const Vec3f& to, double scale, const IsNear& is_near) {
  const Vec3f chord = to - from;
  // Positions are rounded to floats, so tiny steps need a tolerance that does not shrink with the step.
  const float rounding = 4 * std::numeric_limits<float>::epsilon() *
                         std::max(from.cwiseAbs().maxCoeff(), static_cast<float>(scale));
  const float reach = std::max(chord.norm() / 4, rounding);
  return from == to || std::ranges::all_of(std::array{0.25F, 0.5F, 0.75F},
                                           [&](float s) { return is_near(from + s * chord, reach); });
}

}  // namespace

bool CurveGround::connects(const Point& from, const Point& to, double radius) const {
  SurfacePoint near = from.at;
  const auto is_near_base = [&](const Vec3f& point, float reach) {
    const std::optional<Point> found = closest(point, reach, near);
    if (found) near = found->at;
    return found.has_value();
  };
  const auto is_near_surface = [this](const Vec3f& point, float reach) {
    return picker_->closest(point, reach).has_value();
  };
  // Farther than this apart no samples lie on two sides of one groove.
  const double farthest = 4 * radius;
  const auto are_joined = [&] {
    const double apart = static_cast<double>((to.on_surface.position - from.on_surface.position).norm());
    return apart <= farthest && has_path_near_chord(*surface_, from.on_surface, to.on_surface, radius / 2);
  };
  return (base_ && runs_near(from.at.position, to.at.position, scale(), is_near_base)) ||
         runs_near(from.on_surface.position, to.on_surface.position, scale(), is_near_surface) ||
         are_joined();
}

CurveGround::Point CurveGround::on_base(Index near, const Vec3f& point) const {
  const BasePoint found = base_->project(near, point);
  SurfacePoint at;
  at.corners.fill(found.node);
  at.weights = {1, 0, 0};
  at.position = found.position;
  return {at, found.normal, {}};
}

std::optional<CurveGround::Point> CurveGround::closest(const Vec3f& point, float reach,
                                                       const SurfacePoint& near) const {
  if (!base_) {
    const std::optional<SurfacePoint> at = picker_->closest(point, reach);
    if (!at) return {};
    return this->point(*at);
  }
  // Positions on the base surface are accurate to a small share of its spacing.
  constexpr double slack = 0.1;
  const Point found = on_base(near.corners[0], point);
  const double distance = static_cast<double>((found.at.position - point).norm());
  if (!(distance <= static_cast<double>(reach) + slack * base_->spacing())) return {};
  return found;
}

bool CurveGround::is_covered(const Point& point, double reach) const {
  if (!base_) return true;
  const auto height = static_cast<float>(reach);
  const Vec3f above = point.at.position + height * point.normal;
  const std::optional<SurfacePoint> hit = picker_->pick({above, -point.normal});
  return hit && (hit->position - above).norm() <= 2 * height;
}

double CurveGround::point_spacing(const SurfacePoint& at) const {
  if (base_) return base_->spacing() / 2;
  const auto& c = at.corners;
  const Vec3f &a = surface_->positions[c[0]], &b = surface_->positions[c[1]], &d = surface_->positions[c[2]];
  return static_cast<double>(((b - a).norm() + (d - b).norm() + (a - d).norm()) / 6);
}

}  // namespace burin
