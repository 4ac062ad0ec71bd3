#pragma once
#include <burin/refine/region_mesh.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The faces around a vertex in order, counter-clockwise.
struct VertexFan {
  std::vector<Side> leaving;  ///< [face] its side that begins at the vertex
  bool closed = false;        ///< the last face and the first one meet

  std::size_t size() const { return leaving.size(); }
  std::size_t neighbour_count() const { return size() + (closed ? 0 : 1); }
  /// The face after a number, also after the last one of a closed fan.
  std::size_t after(std::size_t i) const { return i + 1 == size() && closed ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return i == 0 && closed ? size() - 1 : i - 1; }
};

/// The side between a vertex and its i-th neighbour, at which its i-th face begins; of an open fan the last
/// one is the side where the last face ends.
inline Side spoke(const VertexFan& fan, std::size_t i) {
  return i < fan.size() ? fan.leaving[i] : RegionMesh::before(fan.leaving[i - 1]);
}

/// The i-th neighbour of the vertex.
inline Index neighbour(const RegionMesh& mesh, const VertexFan& fan, std::size_t i) {
  return i < fan.size() ? mesh.to(fan.leaving[i]) : mesh.from(spoke(fan, i));
}

/// Finds the fan of the vertex at which a side begins. Returns false where its faces are not one fan, more
/// than two meet at an edge, or they disagree on outside. Connects them.
bool find_fan(RegionMesh& mesh, Side side, VertexFan& fan);

}  // namespace burin
