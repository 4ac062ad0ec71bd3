#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// Size of a vertex's cell along a unit tangent, object units: that of the square grid whose edges have the
/// same mean square along it. 0 without neighbours.
float cell_size(const Surface& surface, Index vertex, const Vec3f& tangent);

/// Mean of the normal curvatures in all directions, 1/length, positive where convex seen from outside: half
/// the trace of the linear map of the tangent plane that turns steps to the neighbours into changes of the
/// normal, least squares. 0 where there are too few neighbours for one.
float mean_curvature(const Surface& surface, Index vertex);

/// Umbrella: mean of the neighbours of a vertex minus itself; place(v) says where a vertex stands.
template <class Place>
Vec3f umbrella(const Surface& surface, Index vertex, const Place& place) {
  const auto neighbours = surface.neighbours[vertex];
  if (neighbours.empty()) return Vec3f::Zero();
  const Vec3f centre = place(vertex);
  Vec3f sum = Vec3f::Zero();
  for (const Index neighbour : neighbours) sum += place(neighbour) - centre;
  return sum / static_cast<float>(neighbours.size());
}

}  // namespace burin
