#pragma once
#include <burin/surface/surface.h>

#include <span>

namespace burin {

/// The size of a vertex's cell along a unit tangent, object units: the edge length of the square grid whose
/// edges have the same mean square component along the tangent. 0 without neighbours.
float cell_size(const Surface& surface, Index vertex, const Vec3f& tangent);

/// Mean curvature at a vertex, 1 / length, positive where convex seen from outside: half the trace of the
/// shape operator, a least-squares fit of the changes of the normal along the edges to the neighbours. 0 if
/// there are too few neighbours.
float mean_curvature(const Surface& surface, Index vertex);

/// The umbrella vector of a vertex: the mean of its neighbours' positions minus its own [Taubin 1995].
/// place(v) returns the position of vertex v.
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
