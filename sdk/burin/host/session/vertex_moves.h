#pragma once
#include <burin/base/vector.h>
#include <burin/deform/paint.h>

#include <vector>

namespace burin {

/// The effect of an event on vertices.
struct VertexMoves {
  std::vector<Index> vertices;   ///< each once
  std::vector<Vec3f> positions;  ///< [i] new position of vertices[i]
  std::vector<Tint> tints;       ///< [i] new tint of vertices[i]; empty if the brush writes none
};

}  // namespace burin
