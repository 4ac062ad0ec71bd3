#pragma once
#include <burin/base/index_set.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin {

/// Positions and normals of a surface as they are to be shown while an open stroke displaces it; the
/// surface itself stays as it was when the stroke began. Every call costs in proportion to its vertices.
class ShownSurface {
 public:
  /// Shows the surface as it is. All calls take this surface.
  explicit ShownSurface(const Surface& base);

  std::span<const Vec3f> positions() const { return positions_; }
  std::span<const Vec3f> normals() const { return normals_; }

  /// Moves vertices, each named once, to new places. Returns those that are not where they were, and their
  /// neighbours, whose normals may have changed: ascending, valid until the next call of any method.
  std::span<const Index> move(const Surface& base, std::span<const Index> vertices,
                              std::span<const Vec3f> places);

  /// The vertices that are not where the base has them, ascending: of those that moved since the last call,
  /// or commit().
  std::vector<Index> take_displaced(const Surface& base);

  /// Makes the surface what is shown, given all vertices that differ.
  void commit(Surface& base, std::span<const Index> vertices);

 private:
  void collect_with_neighbours(const Surface& base, std::span<const Index> vertices);

  std::vector<Vec3f> positions_, normals_;  ///< [vertex]
  IndexSet touched_;  ///< vertices that moved since the last take_displaced() or commit()
  IndexSet dirty_;
  std::vector<Index> moved_, changed_;
};

}  // namespace burin
