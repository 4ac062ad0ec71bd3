// Finds the closest of some triangles: rules out by boxes, eight at a time, those that cannot be it, and
// computes the closest point of each of the others.
#include <burin/level_set/near_triangles.h>
#include <burin/surface/geometry/triangle_box.h>
#include <burin/surface/picking/closest_point.h>

#include <algorithm>
#include <limits>

namespace burin {

NearTriangles::NearTriangles(const Surface& surface, std::span<const Index> triangles) : surface_(&surface) {
  for (const Index triangle : triangles)
    add(triangle, triangle_box(surface.positions, surface.triangles[triangle]));
}

void NearTriangles::add(Index triangle, const LanedBoxes::Box& box) {
  triangles_.push_back(triangle);
  boxes_.push_back(box);
}

template <class Reaches, class Visit>
void NearTriangles::for_near(const Vec3f& position, const Reaches& reaches, const Visit& visit) const {
  for (std::size_t first = 0; first < boxes_.size(); first += BoxLanes::count) {
    const BoxLanes::Lane squared = squared_distances(boxes_.run(first / BoxLanes::count), position);
    if (!reaches(squared.minCoeff())) continue;
    for (std::size_t i = first; i < std::min(first + BoxLanes::count, boxes_.size()); ++i)
      if (reaches(squared[static_cast<Eigen::Index>(i - first)])) visit(i);
  }
}

NearTriangles NearTriangles::within(const Vec3f& position, float max_distance) const {
  NearTriangles some(*surface_);
  const float squared = max_distance * max_distance;
  for_near(
      position, [squared](float to) { return to <= squared; },
      [&](std::size_t i) { some.add(triangles_[i], boxes_[i]); });
  return some;
}

Index NearTriangles::closest(const Vec3f& position, Index guess) const {
  const Vec3d query = position.cast<double>();
  const auto to = [&](Index triangle) { return closest_point(*surface_, triangle, query).squared_distance; };
  double least = guess == no_index ? std::numeric_limits<double>::infinity() : to(guess);
  Index closest = guess;
  for_near(
      position, [&](float bound) { return static_cast<double>(bound) <= least; },
      [&](std::size_t i) {
        const Index triangle = triangles_[i];
        const double squared = to(triangle);
        if (squared > least || (squared == least && triangle >= closest)) return;
        least = squared;
        closest = triangle;
      });
  return closest;
}

}  // namespace burin
