#pragma once
#include <burin/deform/paint.h>

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Colours and masks where they differ, or differed.
struct PaintStep {
  std::vector<Index> vertices;  ///< ascending, each once
  std::vector<Vec4f> colours;   ///< [i] of vertices[i]; empty where the surface has no colours
  std::vector<float> masks;     ///< the same of masks
};

/// Colours and masks of a surface as they are to be shown while an open stroke paints it, beside those of
/// when it began.
class ShownPaint {
 public:
  explicit ShownPaint(Index vertex_count) : vertex_count_(vertex_count) {}

  const Paint& base() const { return base_; }
  const Paint& shown() const { return shown_; }

  /// Starts from this paint. Each of its arrays is empty or has an element a vertex.
  void assign(Paint paint);

  /// Makes room for what a brush of these outputs writes: in proportion to the surface, the first time.
  void prepare(std::uint64_t outputs);

  /// Tints vertices, each named once. One whose colour is that of its base gets its very bits, which a
  /// tint does not hold. Appends those that look other than before to `changed`.
  void set(std::span<const Index> vertices, std::span<const Tint> tints, std::vector<Index>& changed);

  /// Makes the base what is shown; returns what was there where they differed.
  PaintStep commit();

  /// Shows the base again. Returns the vertices that may have looked otherwise, ascending.
  std::vector<Index> drop();

  /// Goes back to what a step says, of a surface on which nothing else is shown.
  void restore(const PaintStep& step);

 private:
  std::vector<Index> take_touched();

  Index vertex_count_;
  Paint base_, shown_;
  std::vector<Index> touched_;  ///< since the last commit or drop; some several times
};

}  // namespace burin
