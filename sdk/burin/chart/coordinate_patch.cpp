#include <burin/chart/coordinate_patch.h>
#include <burin/surface/unit_tangent.h>

namespace burin {

CoordinatePatch::Lanes CoordinatePatch::Quadratic::value(const Local& at) const {
  return x * at.x + y * at.y + ((xx * at.x * at.x + yy * at.y * at.y) / 2 + xy * at.x * at.y);
}

CoordinatePatch::Local CoordinatePatch::Quadratic::slope(const Local& at) const {
  return {x + xx * at.x + xy * at.y, y + xy * at.x + yy * at.y};
}

CoordinatePatch::CoordinatePatch(const BasePatch& patch, const ChartFrame& frame)
    : patch_(patch), axis_y_(patch.axis_y()), d_(frame.d) {
  const Vec3f e2 = patch.normal.cross(frame.e1);
  const Vec2f u(frame.e1.dot(patch.axis_x), frame.e1.dot(axis_y_));
  const Vec2f v(e2.dot(patch.axis_x), e2.dot(axis_y_));
  const float k = frame.curvature, j = 1 / frame.stretch, bend = k * j;
  t_terms_ = {j * u.x(), j * u.y(), 2 * bend * u.x() * v.x(), bend * (u.x() * v.y() + u.y() * v.x()),
              2 * bend * u.y() * v.y()};
  d_terms_ = {v.x(), v.y(), -k * u.x() * u.x(), -k * u.x() * u.y(), -k * u.y() * u.y()};
}

CoordinatePatch::Vectors CoordinatePatch::in_space(const Lanes& x, const Lanes& y, const Lanes& z) const {
  const auto component = [&](int i) -> Lanes {
    return x * patch_.axis_x[i] + y * axis_y_[i] + z * patch_.normal[i];
  };
  return {component(0), component(1), component(2)};
}

/// All vectors but the results are along the patch's axes and its normal.
CoordinatePatch::Frames CoordinatePatch::at(const Vectors& points) const {
  const Lanes x = points.x - patch_.position.x(), y = points.y - patch_.position.y(),
              z = points.z - patch_.position.z();
  const auto along = [&](const Vec3f& axis) -> Lanes { return x * axis.x() + y * axis.y() + z * axis.z(); };
  const Local foot = patch_.foot(Local{along(patch_.axis_x), along(axis_y_)}, along(patch_.normal));
  const Local tilt = patch_.slope(foot);
  const Lanes nz = 1 / (1 + tilt.x * tilt.x + tilt.y * tilt.y).sqrt(), nx = -tilt.x * nz, ny = -tilt.y * nz;

  // The gradients along the surface, of squared length |slope|^2 - (normal . slope)^2.
  const Local t = t_terms_.slope(foot), d = d_terms_.slope(foot);
  const Lanes t_up = nx * t.x + ny * t.y, d_up = nx * d.x + ny * d.y;
  const Lanes across = (d.x * d.x + d.y * d.y - d_up * d_up).max(0.F).sqrt();
  // |grad d| is 1 but where lines of the stroke meet; there the node's own frame serves.
  constexpr float least = 0.5F;
  const Lanes scale = 1 / across.max(least);
  const Lanes gx = (d.x - d_up * nx) * scale, gy = (d.y - d_up * ny) * scale, gz = -d_up * nz * scale;

  Frames frames;
  frames.t = t_terms_.value(foot);
  frames.d = d_ + d_terms_.value(foot);
  const Lanes rate = (t.x * t.x + t.y * t.y - t_up * t_up).max(0.F).sqrt();
  frames.stretch = (1 / rate.max(least_stretch)).min(1 / least_stretch).max(least_stretch);
  frames.e1 = in_space(gy * nz - gz * ny, gz * nx - gx * nz, gx * ny - gy * nx);
  frames.normal = in_space(nx, ny, nz);
  frames.certain = (across > least).cast<float>();
  return frames;
}

ChartFrame CoordinatePatch::Frames::frame(int lane, const ChartFrame& node) const {
  ChartFrame frame;
  frame.t = node.t + static_cast<double>(t[lane]);
  frame.d = d[lane];
  frame.e1 = certain[lane] > 0 ? e1[lane] : unit_tangent(node.e1, normal[lane]);
  frame.stretch = stretch[lane];
  return frame;
}

}  // namespace burin
