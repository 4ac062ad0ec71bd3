// Evaluates the base surface below a vertex, in O(1) once the nodes around it are computed.
#include <burin/surface/base_surface/base_foot.h>

#include <cmath>

namespace burin {
namespace {

/// The mean curvature of the graph z = height(x, y) at a point over the tangent plane [do Carmo, Differential
/// Geometry of Curves and Surfaces, section 3-3]. A graph that bends down is convex seen from outside.
double mean_curvature_at(const BasePatch& patch, const BasePatch::Local<float>& at) {
  const BasePatch::Local<float> slope = patch.slope(at);
  const double xx = patch.xx, xy = patch.xy, yy = patch.yy, p = slope.x, q = slope.y;
  const double stretch = 1 + p * p + q * q;
  return -((1 + q * q) * xx - 2 * p * q * xy + (1 + p * p) * yy) / (2 * stretch * std::sqrt(stretch));
}

}  // namespace

Vec3f base_position(BaseSurface& base, const Surface& surface, Index vertex) {
  const BasePatch patch = base.patch(base.node_of(vertex));
  return patch.point_at(patch.foot(surface.positions[vertex]));
}

float base_mean_curvature(BaseSurface& base, const Surface& surface, Index vertex) {
  const Index node = base.node_of(vertex);
  const BasePatch own = base.patch(node);
  const Vec3f& point = surface.positions[vertex];
  const Vec3f foot = own.point_at(own.foot(point));
  double sum = 0, weights = 0;
  for (const auto& [patch, weight] : base.around(node, foot)) {
    sum += weight * mean_curvature_at(patch, patch.foot(point));
    weights += weight;
  }
  return static_cast<float>(weights > 0 ? sum / weights : mean_curvature_at(own, own.foot(point)));
}

}  // namespace burin
