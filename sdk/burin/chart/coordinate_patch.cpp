#include <burin/chart/coordinate_patch.h>
#include <burin/surface/quadratic_fit.h>
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

CoordinatePatch::CoordinatePatch(const BasePatch& patch, const ChartFrame& frame,
                                 std::span<const Told> around, double reach)
    : t_(frame.t), d_(frame.d), e1_(frame.e1) {
  // What the frame tells is fitted apart, so that only what differs from it is left to the places around.
  const Vec3f axis_y = patch.axis_y(), e2 = patch.normal.cross(frame.e1);
  const Vec2f t_slope = Vec2f(frame.e1.dot(patch.axis_x), frame.e1.dot(axis_y)) / frame.stretch;
  const Vec2f d_slope(e2.dot(patch.axis_x), e2.dot(axis_y));
  QuadraticFit<2> fit(reach);
  for (const Told& told : around) {
    const Vec2f at = patch.foot(told.position);
    fit.add(at,
            {told.t - t_ - static_cast<double>(t_slope.dot(at)),
             static_cast<double>(told.d - d_ - d_slope.dot(at))},
            1);
  }
  const QuadraticFit<2>::Terms terms = fit.solve();
  for (std::size_t i = 0; i < 6; ++i) {
    t_terms_[i] = static_cast<float>(terms(static_cast<Eigen::Index>(i), 0));
    d_terms_[i] = static_cast<float>(terms(static_cast<Eigen::Index>(i), 1));
  }
  t_terms_[1] += t_slope.x();
  t_terms_[2] += t_slope.y();
  d_terms_[1] += d_slope.x();
  d_terms_[2] += d_slope.y();
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
