#pragma once
#include <burin/base/vector.h>

#include <map>

namespace burin {

/// Positions and frames of nodes that lie on the result of the stroke's earlier visits.
class CurrentBase {
 public:
  struct Geometry {
    Vec3f position, normal, e1;        ///< object space; the frame is right-handed and orthonormal
    Vec3f fine_position, fine_normal;  ///< position and normal of the fine surface
    Vec3f laplacian;                   ///< umbrella vector of the fine surface
  };

  void set(Index slot, const Geometry& geometry) { geometry_[slot] = geometry; }

  /// The geometry of a node; null for a node without earlier visits.
  const Geometry* find(Index slot) const {
    const auto found = geometry_.find(slot);
    return found == geometry_.end() ? nullptr : &found->second;
  }

 private:
  std::map<Index, Geometry> geometry_;
};

}  // namespace burin
