#pragma once
#include <burin/deform/paint.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Colours and masks of the vertices that a stroke changed, as they were before it.
struct PaintStep {
  std::vector<Index> vertices;  ///< ascending, each once
  std::vector<Vec4f> colours;   ///< [i] of vertices[i]; empty if the surface has no colours
  std::vector<float> masks;     ///< [i] of vertices[i]; empty if the surface has no masks
};

/// The colours and masks to show while an open stroke paints a surface, and those from before the stroke, the
/// base.
class ShownPaint {
 public:
  explicit ShownPaint(Index vertex_count) : vertex_count_(vertex_count) {}

  const Paint& base() const { return base_; }
  const Paint& shown() const { return shown_; }

  /// Sets base and shown paint. Each array is empty or has one element per vertex.
  void assign(Paint paint);

  /// Allocates the arrays that a brush with these outputs writes. Costs O(vertices) the first time.
  void prepare(std::uint64_t outputs);

  /// Sets the tints of vertices, which must be distinct. A tint equal to that of the base restores the exact
  /// bits of the base's colour, which a tint cannot represent. Appends the vertices that changed to
  /// `changed`.
  void set(std::span<const Index> vertices, std::span<const Tint> tints, std::vector<Index>& changed);

  /// Makes the shown paint the base; returns the previous values where they differed.
  PaintStep commit();

  /// Shows the base again. Returns the vertices that may have changed, ascending.
  std::vector<Index> drop();

  /// Restores the values of a step. No stroke may be open. Returns the values that they replaced.
  PaintStep restore(const PaintStep& step);

 private:
  std::vector<Index> take_touched();

  Index vertex_count_;
  Paint base_, shown_;
  std::vector<Index> touched_;  ///< vertices set since the last commit() or drop(), with repetitions
};

}  // namespace burin
