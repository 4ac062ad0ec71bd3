#include <burin/chart/coordinate_patch.h>
#include <burin/surface/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

float value(const std::array<float, 6>& terms, const Vec2f& at) {
  const float x = at.x(), y = at.y();
  return terms[0] + terms[1] * x + terms[2] * y +
         ((terms[3] * x * x + terms[5] * y * y) / 2 + terms[4] * x * y);
}

Vec2f slope(const std::array<float, 6>& terms, const Vec2f& at) {
  return {terms[1] + terms[3] * at.x() + terms[4] * at.y(), terms[2] + terms[4] * at.x() + terms[5] * at.y()};
}

}  // namespace

CoordinatePatch::CoordinatePatch(const BasePatch& patch, const ChartFrame& frame)
    : t_(frame.t), d_(frame.d), e1_(frame.e1) {
  const Vec3f e2 = patch.normal.cross(frame.e1);
  const Vec2f u(frame.e1.dot(patch.axis_x), frame.e1.dot(patch.axis_y()));
  const Vec2f v(e2.dot(patch.axis_x), e2.dot(patch.axis_y()));
  const float k = frame.curvature, j = 1 / frame.stretch, bend = k * j;
  t_terms_ = {0,
              j * u.x(),
              j * u.y(),
              2 * bend * u.x() * v.x(),
              bend * (u.x() * v.y() + u.y() * v.x()),
              2 * bend * u.y() * v.y()};
  d_terms_ = {0, v.x(), v.y(), -k * u.x() * u.x(), -k * u.x() * u.y(), -k * u.y() * u.y()};
}

ChartFrame CoordinatePatch::frame_at(const BasePatch& patch, const Vec2f& at) const {
  const Vec3f normal = patch.normal_at(at);
  const auto gradient = [&](const Vec2f& along) {
    const Vec3f flat = along.x() * patch.axis_x + along.y() * patch.axis_y();
    return Vec3f(flat - normal.dot(flat) * normal);
  };
  const Vec3f across = gradient(slope(d_terms_, at));
  ChartFrame frame;
  frame.t = t_ + static_cast<double>(value(t_terms_, at));
  frame.d = d_ + value(d_terms_, at);
  // |grad d| is 1 but where lines of the stroke meet; there the node's own frame serves.
  constexpr float least = 0.5F;
  frame.e1 = across.norm() > least ? Vec3f(across.cross(normal).normalized()) : unit_tangent(e1_, normal);
  const float along = gradient(slope(t_terms_, at)).norm();
  frame.stretch = std::clamp(1 / along, least_stretch, 1 / least_stretch);
  return frame;
}

}  // namespace burin
