// Extrapolates (t, d) and the frame around a chart node by quadratics that agree to second order with Fermi
// coordinates. Eight points are computed at once, each in O(1).
#include <burin/chart/transfer/coordinate_patch.h>

namespace burin {

CoordinatePatch::Lanes CoordinatePatch::Quadratic::value(const Feet& at) const {
  return x * at.x + y * at.y + ((xx * at.x * at.x + yy * at.y * at.y) / 2 + xy * at.x * at.y);
}

CoordinatePatch::Feet CoordinatePatch::Quadratic::slope(const Feet& at) const {
  return {x + xx * at.x + xy * at.y, y + xy * at.x + yy * at.y};
}

CoordinatePatch::CoordinatePatch(const BasePatch& patch, const ChartFrame& frame, const DistanceRay& ray)
    : patch_(patch), axis_y_(patch.axis_y()), of_node_(frame) {
  const Vec3f e2 = patch.normal.cross(frame.e1);
  const Vec2f e1_flat(frame.e1.dot(patch.axis_x), frame.e1.dot(axis_y_));
  const Vec2f e2_flat(e2.dot(patch.axis_x), e2.dot(axis_y_));
  // u is the direction across the ray, v the direction along it.
  const Vec2f u = ray.left * e1_flat - ray.ahead * e2_flat, v = ray.ahead * e1_flat + ray.left * e2_flat;
  const float k = frame.curvature, j = 1 / frame.stretch, twist = k * j;
  const Quadratic beside{j * u.x(), j * u.y(), 2 * twist * u.x() * v.x(),
                         twist * (u.x() * v.y() + u.y() * v.x()), 2 * twist * u.y() * v.y()};
  const float bend = bend_across(ray, k, j);
  const Quadratic away{v.x(), v.y(), -bend * u.x() * u.x(), -bend * u.x() * u.y(), -bend * u.y() * u.y()};
  t_terms_ = sum(ray.left, beside, ray.ahead, away);
  d_terms_ = sum(ray.left, away, -ray.ahead, beside);
}

CoordinatePatch::Quadratic CoordinatePatch::sum(float a, const Quadratic& of_a, float b,
                                                const Quadratic& of_b) {
  return {a * of_a.x + b * of_b.x, a * of_a.y + b * of_b.y, a * of_a.xx + b * of_b.xx,
          a * of_a.xy + b * of_b.xy, a * of_a.yy + b * of_b.yy};
}

/// Component i, in space, of a vector given in the patch's axes and normal.
CoordinatePatch::Lanes CoordinatePatch::component(int i, const Lanes& x, const Lanes& y,
                                                  const Lanes& z) const {
  return x * patch_.axis_x[i] + y * axis_y_[i] + z * patch_.normal[i];
}

/// All vectors but the results are in the basis of the patch's axes and its normal.
CoordinatePatch::Frames CoordinatePatch::at(const Feet& feet) const {
  const Feet tilt = patch_.slope(feet);
  const Lanes nz = 1 / (1 + tilt.x * tilt.x + tilt.y * tilt.y).sqrt(), nx = -tilt.x * nz, ny = -tilt.y * nz;

  // The tangential gradients have the squared length |slope|^2 - (normal . slope)^2.
  const Feet t = t_terms_.slope(feet), d = d_terms_.slope(feet);
  const Lanes t_up = nx * t.x + ny * t.y, d_up = nx * d.x + ny * d.y;
  const Lanes across = (d.x * d.x + d.y * d.y - d_up * d_up).max(0.F).sqrt();
  // |grad d| is 1 except near focal points, where the node's own frame is used.
  constexpr float least = 0.5F;
  const Lanes scale = 1 / across.max(least);
  const Lanes gx = (d.x - d_up * nx) * scale, gy = (d.y - d_up * ny) * scale, gz = -d_up * nz * scale;
  const Lanes ex = gy * nz - gz * ny, ey = gz * nx - gx * nz, ez = gx * ny - gy * nx;

  Frames frames;
  frames.t = t_terms_.value(feet);
  frames.d = of_node_.d + d_terms_.value(feet);
  const Lanes rate = (t.x * t.x + t.y * t.y - t_up * t_up).max(0.F).sqrt();
  frames.stretch = (1 / rate.max(least_stretch)).min(1 / least_stretch).max(least_stretch);
  frames.e1_x = component(0, ex, ey, ez);
  frames.e1_y = component(1, ex, ey, ez);
  frames.e1_z = component(2, ex, ey, ez);
  frames.certain = (across > least).cast<float>();
  return frames;
}

}  // namespace burin
