#pragma once
#include <burin/ink/parse/byte_reader.h>
#include <burin/ink/pen_file.h>

#include <cstdint>

namespace burin {

/// How the points of a line are written.
enum class RemarkablePoints {
  floats,  ///< x, y, speed, direction, width, pressure
  small,   ///< x, y as floats; speed, width in quarters, direction and pressure as small integers
};

constexpr std::size_t remarkable_float_point = 24, remarkable_small_point = 14;  ///< bytes

/// Adds all points that the bytes have to the stroke.
void add_remarkable_points(ByteReader bytes, RemarkablePoints points, PenStroke& stroke);

/// Whether a line's pen number is that of an eraser.
void set_remarkable_pen(std::uint32_t pen, PenStroke& stroke);

/// Reads the blocks of version 6, behind the head of the file. Layers without lines do not count; layers and
/// lines have the order that their ids tell, whatever that of the blocks.
void read_remarkable_blocks(ByteReader bytes, PenFile& content);

}  // namespace burin
