// The foot point is found by two fixed-point iterations, so that the same point always takes the same work.
#include <burin/surface/base_surface/base_patch.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace burin {

BasePatch::Local<float> BasePatch::foot(const Vec3f& point) const {
  const Vec3f way = point - position;
  const Local<float> below{way.dot(axis_x), way.dot(axis_y())};
  const float above = way.dot(normal), farthest = 0.5F / std::sqrt(xx * xx + 2 * xy * xy + yy * yy);
  Local<float> at = below;
  for (int i = 0; i < 2; ++i) {
    const Local<float> tilt = slope(at);
    const float left = std::clamp(above - height(at), -farthest, farthest);
    at = {below.x + left * tilt.x, below.y + left * tilt.y};
  }
  return at;
}

BasePatch::Local<float> BasePatch::foot_within(const Vec3f& point, float extent) const {
  const Local<float> at = foot(point);
  const float distance = Vec2f(at.x, at.y).stableNorm();
  if (distance <= extent) return at;
  return {at.x / distance * extent, at.y / distance * extent};
}

Vec3f BasePatch::point_at(const Local<float>& at) const {
  return position + at.x * axis_x + at.y * axis_y() + height(at) * normal;
}

Vec3f BasePatch::normal_at(const Local<float>& at) const {
  const Local<float> tilt = slope(at);
  return (normal - tilt.x * axis_x - tilt.y * axis_y()).normalized();
}

}  // namespace burin
