// Finds the closest of some triangles: rules out by boxes, eight at a time, those that cannot be it, and
// computes the closest point of each of the others.
#include <burin/level_set/near_triangles.h>
#include <burin/surface/picking/closest_point.h>

#include <algorithm>
#include <limits>

namespace burin {
namespace {

BoxLanes::Box box_around(const Surface& surface, Index triangle) {
  BoxLanes::Box box;
  for (const Index corner : surface.triangles[triangle]) box.extend(surface.positions[corner]);
  return box;
}

/// Calls visit(i) for the boxes that are as near as reaches(squared distance) says, in their order.
template <class Reaches, class Visit>
void for_near(const std::vector<BoxLanes>& boxes, std::size_t count, const Vec3f& position,
              const Reaches& reaches, const Visit& visit) {
  for (std::size_t first = 0; first < count; first += BoxLanes::count) {
    const BoxLanes::Lane squared = squared_distances(boxes[first / BoxLanes::count], position);
    if (!reaches(squared.minCoeff())) continue;
    for (std::size_t i = first; i < std::min(first + BoxLanes::count, count); ++i)
      if (reaches(squared[static_cast<Eigen::Index>(i - first)])) visit(i);
  }
}

}  // namespace

NearTriangles::NearTriangles(const Surface& surface, std::vector<Index> triangles) : surface_(&surface) {
  for (const Index triangle : triangles) add(triangle, box_around(surface, triangle));
}

void NearTriangles::add(Index triangle, const BoxLanes::Box& box) {
  if (triangles_.size() % BoxLanes::count == 0) boxes_.emplace_back();
  boxes_.back().set(triangles_.size() % BoxLanes::count, box);
  triangles_.push_back(triangle);
}

NearTriangles NearTriangles::within(const Vec3f& position, float max_distance) const {
  NearTriangles some(*surface_);
  const float squared = max_distance * max_distance;
  for_near(
      boxes_, triangles_.size(), position, [squared](float to) { return to <= squared; },
      [&](std::size_t i) { some.add(triangles_[i], boxes_[i / BoxLanes::count].box(i % BoxLanes::count)); });
  return some;
}

Index NearTriangles::closest(const Vec3f& position, Index guess) const {
  const Vec3d query = position.cast<double>();
  const auto to = [&](Index triangle) { return closest_point(*surface_, triangle, query).squared_distance; };
  double least = guess == no_index ? std::numeric_limits<double>::infinity() : to(guess);
  Index closest = guess;
  for_near(
      boxes_, triangles_.size(), position, [&](float bound) { return static_cast<double>(bound) <= least; },
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
