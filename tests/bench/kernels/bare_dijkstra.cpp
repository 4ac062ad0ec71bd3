#include "bare_dijkstra.h"

#include <limits>
#include <queue>
#include <utility>

namespace burin::kernels {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

BareDijkstra::BareDijkstra(const Surface& surface)
    : surface_(&surface), distance_(surface.vertex_count(), infinity) {}

std::span<const Index> BareDijkstra::run(const SurfaceCurve& curve, float radius) {
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index vertex : reached_) distance_[vertex] = infinity;
  reached_.clear();
  const std::vector<Vec3f>& positions = surface_->positions;
  const auto offer = [&](Index vertex, float distance) {
    if (distance > radius || distance >= distance_[vertex]) return;
    distance_[vertex] = distance;
    queue.emplace(distance, vertex);
  };
  for (const CurvePoint& point : curve.points)
    for (const Index corner : point.at.corners) offer(corner, (positions[corner] - point.at.position).norm());
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distance_[vertex]) continue;
    reached_.push_back(vertex);
    for (const Index next : surface_->neighbours[vertex])
      offer(next, distance + (positions[next] - positions[vertex]).norm());
  }
  return reached_;
}

}  // namespace burin::kernels
