#include <burin/surface/base_patch.h>

#include <Eigen/Geometry>

namespace burin {

BasePatch::Local<float> BasePatch::foot(const Vec3f& point) const {
  const Vec3f way = point - position;
  return foot(Local<float>{way.dot(axis_x), way.dot(axis_y())}, way.dot(normal));
}

BasePatch::Local<float> BasePatch::foot_within(const Vec3f& point, float extent) const {
  const Local<float> at = foot(point);
  const float distance = Vec2f(at.x, at.y).stableNorm();
  if (distance <= extent) return at;
  return {at.x / distance * extent, at.y / distance * extent};
}

Vec3f BasePatch::place(const Local<float>& at) const {
  return position + at.x * axis_x + at.y * axis_y() + height(at) * normal;
}

Vec3f BasePatch::normal_at(const Local<float>& at) const {
  const Local<float> tilt = slope(at);
  return (normal - tilt.x * axis_x - tilt.y * axis_y()).normalized();
}

}  // namespace burin
