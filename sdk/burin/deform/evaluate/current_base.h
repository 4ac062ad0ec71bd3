#pragma once
#include <burin/base/vector.h>

#include <map>

namespace burin {

/// Where nodes stand that do not stand on the base surface: on what the stroke made of it before.
class CurrentBase {
 public:
  struct Place {
    Vec3f position, normal, e1;        ///< object space; frame right-handed and orthonormal
    Vec3f fine_position, fine_normal;  ///< the same of the fine surface
    Vec3f laplacian;                   ///< of the fine surface as it is there
  };

  void set(Index slot, const Place& place) { places_[slot] = place; }

  /// Null for a node that stands on the base.
  const Place* find(Index slot) const {
    const auto found = places_.find(slot);
    return found == places_.end() ? nullptr : &found->second;
  }

 private:
  std::map<Index, Place> places_;
};

}  // namespace burin
