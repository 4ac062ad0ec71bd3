// Averages the normal coordinates and frames that upwind neighbours predict for a vertex [Schmidt 2010], in
// O(n) for n neighbours. Only predictions that agree with that of the shortest path count.
#include <burin/chart/dabs/normal_coordinates.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

bool agree(const DabPrediction& a, const DabPrediction& b) {
  return (a.frame.at - b.frame.at).norm() <= 2 * (a.length + b.length);
}

}  // namespace

DabFrame upwind_mean(std::span<const DabPrediction> predictions, const Vec3f& normal, float epsilon) {
  const DabPrediction& shortest = *std::ranges::min_element(
      predictions, {}, [](const DabPrediction& p) { return std::pair(p.g, p.from); });
  float weights = 0;
  Vec2f at = Vec2f::Zero();
  Vec3f e1 = Vec3f::Zero();
  for (const DabPrediction& prediction : predictions) {
    if (!agree(prediction, shortest)) continue;
    const float w = 1 / (prediction.length + epsilon);
    weights += w;
    at += w * prediction.frame.at;
    e1 += w * prediction.frame.e1;
  }
  return {at / weights, unit_tangent(e1, normal)};
}

}  // namespace burin
