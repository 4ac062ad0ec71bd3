#pragma once
#include <burin/deform/shown/same_bits.h>
#include <burin/host/c/placement.h>
#include <burin/surface/surface.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace burin::c {

/// The positions of an object as its owner has them, beside a surface that lies in the world. Vertices that
/// are where they were given keep the bits that they were given with; 12 bytes a vertex for that.
class ObjectSpace {
 public:
  /// `given`: [vertex of the original mesh] in the object.
  ObjectSpace(const Placement& placement, std::vector<Vec3f> given)
      : placement_(placement), given_(std::move(given)) {}

  const Placement& placement() const { return placement_; }

  /// The position in the object of a vertex of the original mesh that is at `world`.
  Vec3f position(Index source, const Vec3f& world) const {
    const Vec3f there = placement_.to_world(given_[source]);
    return same_bits(there, world) ? given_[source] : placement_.to_object(world);
  }

  Vec3f normal(const Vec3f& world) const { return placement_.normal_to_object(world); }

  /// Follows a surface that has other vertices. What was given stays, as undo brings its vertices back.
  void resize(const Surface& surface) {
    const auto before = static_cast<Index>(given_.size());
    given_.resize(std::max(before, surface.vertex_count()));
    for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
      if (const Index source = surface.source_vertex[vertex]; source >= before)
        given_[source] = placement_.to_object(surface.positions[vertex]);
  }

  /// Takes a position that the owner gave to a vertex of the original mesh; returns whether it has other bits
  /// than the one given before.
  bool take(Index source, const Vec3f& position) {
    const bool same = same_bits(given_[source], position);
    given_[source] = position;
    return !same;
  }

 private:
  Placement placement_;
  std::vector<Vec3f> given_;
};

}  // namespace burin::c
