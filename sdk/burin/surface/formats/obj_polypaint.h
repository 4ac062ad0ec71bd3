#pragma once
#include <burin/surface/vertex_paint.h>

#include <cstddef>
#include <string_view>

namespace burin {

/// Colours and masks that ZBrush writes to the comments of an OBJ file. After `#MRGB` each vertex, in the
/// file's order, has eight hexadecimal digits, two each for mask, red, green and blue; a line holds up to 64
/// vertices. A mask of ff means free. Colours cover the clay fully.
class ObjPolypaint {
 public:
  /// Reads the comments of a file.
  explicit ObjPolypaint(std::string_view text);

  bool empty() const { return lines_ == 0; }

  /// The number of such lines in the file.
  std::size_t lines() const { return lines_; }

  /// Whether the lines are well-formed and hold exactly this many vertices.
  bool is_of(std::size_t vertices) const { return sound_ && paint_.colours.size() == vertices; }

  /// The colours and masks; masks are empty if all are free.
  const VertexPaint& paint() const { return paint_; }

 private:
  void read_line(std::string_view digits);

  VertexPaint paint_;
  std::size_t lines_ = 0;
  bool sound_ = true;
};

}  // namespace burin
