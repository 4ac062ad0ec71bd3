#pragma once
#include <burin/deform/shown/undo_journal.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <optional>

namespace burin {

/// A number for all positions, colours and masks of a surface, by which states of one surface are told apart:
/// the sum of a hash of every value with its vertex, modulo 2^64. As a sum it follows changes at a cost in
/// proportion to them, in any order. Vertices count with their numbers in the original mesh, bare colours and
/// masks with nothing, so that surfaces that show the same have the same number.
class SurfaceState {
 public:
  /// The number of this surface; O(vertices) the first time after a reset.
  std::uint64_t of(const Surface& surface, const Paint& paint);

  /// Forgets the number, since all may have changed.
  void reset() { sum_.reset(); }

  /// A vertex, by its number in the original mesh, moved.
  void moved(Index source, const Vec3f& from, const Vec3f& to) {
    if (sum_) *sum_ += term(source, to) - term(source, from);
  }

  /// `before` are the values that the paint of vertices of the surface had.
  void repainted(const Surface& surface, const PaintStep& before, const Paint& now) {
    if (sum_) *sum_ += difference(surface, before, now);
  }

  /// The number that the surface would have with the values of a step; of() must have been called.
  std::uint64_t with(const UndoStep& step, const Surface& surface, const Paint& paint) const;

 private:
  static std::uint64_t term(Index source, const Vec3f& position);
  static std::uint64_t term(Index source, const Vec4f& colour);
  static std::uint64_t term(Index source, float mask);
  static std::uint64_t difference(const Surface& surface, const PaintStep& before, const Paint& now);

  std::optional<std::uint64_t> sum_;
};

}  // namespace burin
