#pragma once
#include <burin/surface/surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin {

/// Slabs around runs of long thin triangles, as those of a fan of many spokes: their boxes are so large that
/// a position may lie in very many of them. A slab is what lies between two planes along the longest edge of
/// a run's first triangle. A mesh with few such runs has no slabs. The surface must outlive the object.
class SliverSlabs {
 public:
  /// Of runs of this many consecutive triangles.
  SliverSlabs(const Surface& surface, std::size_t run_length);

  /// Follows a change of a triangle's corners.
  void update(Index triangle) {
    if (!slabs_.empty()) slabs_[triangle / run_length_] = slab_of(triangle / run_length_);
  }

  /// A lower bound of the squared distance from a position to the triangles of the run that begins with this
  /// one.
  double nearest(Index begin, const Vec3d& position) const {
    if (slabs_.empty()) return 0;
    const Slab& slab = slabs_[begin / run_length_];
    const double at = slab.across.dot(position);
    const double outside = std::max({slab.least - at, at - slab.most, 0.0});
    return outside * outside;
  }

 private:
  /// least <= across . x <= most.
  struct Slab {
    Vec3d across = Vec3d::Zero();  ///< unit; zero if the box of the run fits well
    double least = 0, most = 0;
  };

  bool box_fits(std::size_t run) const;
  Slab slab_of(std::size_t run) const;
  template <class Visit>
  void for_triangles(std::size_t run, const Visit& visit) const;

  const Surface* surface_;
  std::size_t run_length_;
  std::vector<Slab> slabs_;  ///< [run]
};

}  // namespace burin
