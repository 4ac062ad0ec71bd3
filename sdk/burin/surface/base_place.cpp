#include <burin/base/sort_unique.h>
#include <burin/surface/base_place.h>
#include <burin/surface/quadratic_fit.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

/// Over which paraboloids are blended, in spacings.
constexpr double blend_over_spacing = 1.6;

/// A node and those at most two steps from it, each once.
std::vector<Index> two_rings(const BaseSurface& base, Index node) {
  const Csr& neighbours = base.neighbours();
  std::vector<Index> nodes{node};
  for (const Index one : neighbours[node]) {
    nodes.push_back(one);
    nodes.insert(nodes.end(), neighbours[one].begin(), neighbours[one].end());
  }
  sort_unique(nodes);
  return nodes;
}

/// Of the graph z = height(x, y) at a place over the tangent plane [do Carmo, Differential Geometry of Curves
/// and Surfaces, section 3-3]; a graph that bends down is convex seen from outside.
double mean_curvature_at(const BasePatch& patch, const BasePatch::Local<float>& at) {
  const BasePatch::Local<float> slope = patch.slope(at);
  const double xx = patch.xx, xy = patch.xy, yy = patch.yy, p = slope.x, q = slope.y;
  const double stretch = 1 + p * p + q * q;
  return -((1 + q * q) * xx - 2 * p * q * xy + (1 + p * p) * yy) / (2 * stretch * std::sqrt(stretch));
}

}  // namespace

Vec3f base_position(BaseSurface& base, const Surface& surface, Index vertex) {
  const BasePatch patch = base.patch(base.node_of(vertex));
  return patch.place(patch.foot(surface.positions[vertex]));
}

float base_mean_curvature(BaseSurface& base, const Surface& surface, Index vertex) {
  const Index node = base.node_of(vertex);
  const BasePatch own = base.patch(node);
  const Vec3f& point = surface.positions[vertex];
  const Vec3f foot = own.place(own.foot(point));
  const double reach = blend_over_spacing * base.spacing();
  double sum = 0, weights = 0;
  for (const Index other : two_rings(base, node)) {
    const BasePatch patch = base.patch(other);
    const double squared = static_cast<double>((patch.position - foot).squaredNorm()) / (reach * reach);
    const double weight = patch.normal.dot(own.normal) > 0 ? bump_weight(squared) : 0;
    if (!(weight > 0)) continue;
    sum += weight * mean_curvature_at(patch, patch.foot(point));
    weights += weight;
  }
  return static_cast<float>(weights > 0 ? sum / weights : mean_curvature_at(own, own.foot(point)));
}

}  // namespace burin
