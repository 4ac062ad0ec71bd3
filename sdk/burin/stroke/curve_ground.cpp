#include <burin/stroke/curve_ground.h>
#include <burin/surface/normals.h>

namespace burin {

CurveGround::Place CurveGround::place(const SurfacePoint& at) const {
  if (!base_) return {at, normal_at(*surface_, at)};
  return on_base(base_->node_of(at.corners[0]), at.position);
}

CurveGround::Place CurveGround::on_base(Index near, const Vec3f& point) const {
  const BasePoint found = base_->project(near, point);
  SurfacePoint at;
  at.corners.fill(found.node);
  at.weights = {1, 0, 0};
  at.position = found.position;
  return {at, found.normal};
}

std::optional<CurveGround::Place> CurveGround::closest(const Vec3f& point, float reach,
                                                       const SurfacePoint& near) const {
  if (!base_) {
    const std::optional<SurfacePoint> at = picker_->closest(point, reach);
    if (!at) return {};
    return place(*at);
  }
  // Places on the base surface are right to a small share of its spacing.
  constexpr double slack = 0.1;
  const Place place = on_base(near.corners[0], point);
  const double distance = static_cast<double>((place.at.position - point).norm());
  if (distance > static_cast<double>(reach) + slack * base_->spacing()) return {};
  return place;
}

double CurveGround::point_spacing(const SurfacePoint& at) const {
  if (base_) return base_->spacing() / 2;
  const auto& c = at.corners;
  const Vec3f &a = surface_->positions[c[0]], &b = surface_->positions[c[1]], &d = surface_->positions[c[2]];
  return static_cast<double>(((b - a).norm() + (d - b).norm() + (a - d).norm()) / 6);
}

}  // namespace burin
