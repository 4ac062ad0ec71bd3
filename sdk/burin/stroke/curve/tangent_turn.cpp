// Sums up the turns of a polyline's tangent from point to point, each measured after parallel transport. O(1)
// per point that changed.
#include <burin/math/elementary.h>
#include <burin/stroke/curve/tangent_turn.h>
#include <burin/surface/geometry/parallel_transport.h>

#include <algorithm>

namespace burin {
namespace {

/// The angle by which the tangent turns from a to b, radians.
double turn_between(const CurvePoint& a, const CurvePoint& b) {
  const Vec3f carried = transport(a.tangent, a.normal, b.normal);
  const double sine = b.normal.cross(carried).dot(b.tangent);
  return math::atan2(sine, static_cast<double>(carried.dot(b.tangent)));
}

}  // namespace

void TangentTurn::update(const SurfaceCurve& curve, std::size_t first_changed) {
  const auto& points = curve.points;
  angles_.resize(points.size());
  angles_[0] = 0;
  for (std::size_t i = std::max<std::size_t>(first_changed, 1); i < points.size(); ++i)
    angles_[i] = angles_[i - 1] + turn_between(points[i - 1], points[i]);
  closing_ = curve.closed ? turn_between(points.back(), points.front()) : 0;
}

}  // namespace burin
