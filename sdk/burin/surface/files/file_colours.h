#pragma once
#include <burin/surface/files/unused_count.h>
#include <burin/surface/vertex_paint.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Colours of vertices as a text file has them: numbers whose range it does not name.
class FileColours {
 public:
  /// Red, green, blue and coverage.
  using Colour = std::array<double, 4>;

  /// Gives a colour to a vertex later than those that have one.
  void add(std::size_t vertex, const Colour& colour);

  /// Hands them to `paint`, of so many vertices; those without one are bare. `full`: the greatest channel;
  /// where the format does not say, 1, or 255 where any of red, green and blue is above 1. Colours beyond the
  /// range by more than rounding are none: they are counted instead.
  void give(VertexPaint& paint, std::size_t vertices, std::optional<double> full, UnusedCount& unused);

 private:
  std::vector<std::optional<Colour>> colours_;  ///< [vertex], up to the last that has one
};

}  // namespace burin
