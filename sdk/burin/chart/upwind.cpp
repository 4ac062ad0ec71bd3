#include <burin/chart/upwind.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

bool agree(const Prediction& a, const Prediction& b) {
  const double reach = 2 * static_cast<double>(a.length + b.length);
  return std::hypot(a.frame.t - b.frame.t, static_cast<double>(a.frame.d - b.frame.d)) <= reach;
}

Vec3f unit_tangent(const Vec3f& vector, const Vec3f& normal) {
  const Vec3f tangent = vector - normal.dot(vector) * normal;
  const float size = tangent.norm();
  return size > 0 ? Vec3f(tangent / size) : normal.unitOrthogonal();
}

}  // namespace

ChartFrame upwind_mean(std::span<const Prediction> predictions, const Vec3f& normal, float epsilon) {
  const Prediction& nearest = *std::ranges::min_element(
      predictions, {}, [](const Prediction& p) { return std::pair(std::abs(p.frame.d), p.from); });
  // t is summed relative to one prediction's, for floats of full accuracy.
  float weights = 0, t = 0, d = 0;
  Vec3f e1 = Vec3f::Zero();
  for (const Prediction& prediction : predictions) {
    if (!agree(prediction, nearest)) continue;
    const float w = 1 / (prediction.length + epsilon);
    weights += w;
    t += w * static_cast<float>(prediction.frame.t - nearest.frame.t);
    d += w * prediction.frame.d;
    e1 += w * prediction.frame.e1;
  }
  return {nearest.frame.t + static_cast<double>(t / weights), d / weights, unit_tangent(e1, normal)};
}

}  // namespace burin
