#pragma once
#include <burin/surface/files/unused_count.h>
#include <burin/surface/vertex_paint.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Colours of vertices from a text file, in which the range of the numbers is not stated.
class FileColours {
 public:
  /// Red, green, blue and coverage.
  using Colour = std::array<double, 4>;

  static constexpr double covering = 1e9;  ///< full coverage, whatever the channels range to

  /// Sets the colour of a vertex. Vertices must be given in ascending order.
  void add(std::size_t vertex, const Colour& colour);

  /// The same of four numbers, of which the file does not tell what they are: red, green, blue and coverage,
  /// or a weight of the position, red, green and blue. The latter only if all weights are 1 and not all of
  /// the last numbers.
  void add_four(std::size_t vertex, const Colour& numbers);

  /// Writes the colours to `paint`, which has this many vertices; vertices without a colour get coverage 0.
  /// `full` is the greatest channel value. If the format does not define it, it is 255 when any of red, green
  /// and blue is above 1, else 1. If any colour lies outside the range by more than rounding, no colour is
  /// used and all are counted in `unused`.
  void give(VertexPaint& paint, std::size_t vertices, std::optional<double> full, UnusedCount& unused);

 private:
  void settle_fours();

  std::vector<std::optional<Colour>> colours_;  ///< [vertex], up to the last one with a colour
  bool shares_ = false;                         ///< coverage ranges to 1, whatever the channels range to
  std::vector<std::size_t> fours_;              ///< vertices of add_four()
};

}  // namespace burin
