#pragma once
#include <burin/deform/paint.h>

#include <cstddef>
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
/// base. While no stroke is open an array is there if it was assigned or if a vertex has another value than
/// bare ones: what takes all painting back takes the array, too.
class ShownPaint {
 public:
  explicit ShownPaint(Index vertex_count) : vertex_count_(vertex_count) {}

  const Paint& base() const { return base_; }
  const Paint& shown() const { return shown_; }

  /// Sets base and shown paint. Each array is empty or has one element per vertex. O(vertices).
  void assign(Paint paint);

  /// Goes over to a surface of so many vertices that has this paint; returns the base of the one before.
  /// Arrays that strokes made remain theirs. O(vertices).
  Paint exchange(Index vertex_count, Paint paint);

  /// Makes the arrays that a brush with these outputs writes. Costs O(vertices) the first time.
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
  /// What is known of the arrays of one kind of values.
  template <class Value>
  struct Kind {
    Value bare;
    bool assigned = false;               ///< not only painted by strokes
    std::size_t painted = 0;             ///< vertices of the base whose value is not bare
    std::vector<Value> base{}, shown{};  ///< bare ones for the next stroke, while there are no arrays
  };

  template <class Value>
  void prepare(std::vector<Value> Paint::*values, Kind<Value>& kind);
  template <class Value>
  void put_away(std::vector<Value> Paint::*values, Kind<Value>& kind);
  void put_away();
  void set_all(Paint paint);
  std::vector<Index> take_touched();

  Index vertex_count_;
  Paint base_, shown_;
  Kind<Vec4f> colours_{Paint::bare()};
  Kind<float> masks_{1};
  std::vector<Index> touched_;  ///< vertices set since the last commit() or drop(), with repetitions
};

}  // namespace burin
