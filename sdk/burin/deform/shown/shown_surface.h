#pragma once
#include <burin/base/index_set.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// The positions and normals to show while an open stroke displaces a surface; the surface itself does not
/// change until commit(). Every call costs in proportion to its vertices.
class ShownSurface {
 public:
  /// Copies positions and normals. All calls must be given this surface.
  explicit ShownSurface(const Surface& base);

  std::span<const Vec3f> positions() const { return positions_; }
  std::span<const Vec3f> normals() const { return normals_; }

  /// Moves vertices, which must be distinct, to new positions. Returns the vertices that moved and their
  /// neighbours, whose normals may have changed, ascending. The span is valid until the next call of any
  /// method.
  std::span<const Index> move(const Surface& base, std::span<const Index> vertices,
                              std::span<const Vec3f> positions);

  /// Among the vertices that moved since the last call, or commit(), those whose position differs from the
  /// base; ascending.
  std::vector<Index> take_displaced(const Surface& base);

  /// The same without taking them.
  std::vector<Index> displaced(const Surface& base);

  /// Copies the shown positions and normals to the surface and updates its curvature. `vertices` are all
  /// vertices whose positions differ.
  void commit(Surface& base, std::span<const Index> vertices);

 private:
  void collect_with_neighbours(const Surface& base, std::span<const Index> vertices);

  std::vector<Vec3f> positions_, normals_;  ///< [vertex]
  IndexSet touched_;  ///< vertices that moved since the last take_displaced() or commit()
  IndexSet dirty_;
  std::vector<Index> moved_, changed_;
};

}  // namespace burin
