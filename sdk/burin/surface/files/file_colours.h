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

  /// Sets the colour of a vertex. Vertices must be given in ascending order.
  void add(std::size_t vertex, const Colour& colour);

  /// Writes the colours to `paint`, which has this many vertices; vertices without a colour get coverage 0.
  /// `full` is the greatest channel value. If the format does not define it, it is 255 when any of red, green
  /// and blue is above 1, else 1. If any colour lies outside the range by more than rounding, no colour is
  /// used and all are counted in `unused`.
  void give(VertexPaint& paint, std::size_t vertices, std::optional<double> full, UnusedCount& unused);

 private:
  std::vector<std::optional<Colour>> colours_;  ///< [vertex], up to the last one with a colour
};

}  // namespace burin
