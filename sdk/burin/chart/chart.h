#pragma once
#include <burin/base/vector.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The coordinates of the region around a stroke, one node a vertex, structure of arrays. At each node
/// stands the frame (e1, e2 = n x e1, n); d > 0 on the left of the direction of travel, in the direction
/// of e2. (The sign formula of the paper, section 2, gives the right.)
struct Chart {
  std::vector<Index> vertex;  ///< of the surface, ascending
  std::vector<double> t;      ///< arc length along the stroke, object units; beyond [0, length] in round caps
  std::vector<float> d;       ///< signed geodesic distance to the stroke, object units, |d| <= radius
  std::vector<Vec3f> e1;      ///< unit, at right angles to the vertex normal, along the stroke

  std::size_t size() const { return vertex.size(); }
};

}  // namespace burin
