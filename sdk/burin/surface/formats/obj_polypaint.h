#pragma once
#include <burin/surface/vertex_paint.h>

#include <cstddef>
#include <string_view>

namespace burin {

/// Colours and masks as ZBrush writes them into the comments of an OBJ file: `#MRGB`, then for each vertex in
/// the file's order eight hexadecimal digits, two each for mask, red, green and blue, of up to 64 vertices a
/// line. A mask of ff is free. Colours cover all.
class ObjPolypaint {
 public:
  /// Reads the comments of a file.
  explicit ObjPolypaint(std::string_view text);

  bool empty() const { return lines_ == 0; }

  /// The number of lines met.
  std::size_t lines() const { return lines_; }

  /// Whether the lines are as they should be and name each of these vertices once.
  bool is_of(std::size_t vertices) const { return sound_ && paint_.colours.size() == vertices; }

  /// Masks are left out where all are free.
  const VertexPaint& paint() const { return paint_; }

 private:
  void read_line(std::string_view digits);

  VertexPaint paint_;
  std::size_t lines_ = 0;
  bool sound_ = true;
};

}  // namespace burin
