// Reads pages of reMarkable tablets, .rm of the versions 3, 5 and 6. Version 6 is a list of blocks
// (remarkable_blocks.h); before it, layers hold lines and these points. Positions are pixels of 1/226 inch;
// in version 6, x counts from the middle of the page. The direction of a point is that of the stroke, no tilt
// of the pen; of time there is only the speed.
#include <burin/ink/decode/remarkable_blocks.h>
#include <burin/ink/kinds/kinds.h>
#include <burin/ink/pen_file.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr std::string_view head_text = "reMarkable .lines file, version=";
constexpr std::size_t head_size = 43;

PenStroke read_line(ByteReader& bytes, char version) {
  constexpr std::size_t unknown = 4, base_width = 4;
  const auto pen = bytes.take<std::uint32_t>();
  bytes.take_bytes(4 + unknown + base_width + (version == '5' ? unknown : 0));  // the colour first
  PenStroke stroke;
  set_remarkable_pen(pen, stroke);
  const auto points = bytes.take<std::uint32_t>();
  add_remarkable_points(bytes.part(std::uint64_t{points} * remarkable_float_point), RemarkablePoints::floats,
                        stroke);
  return stroke;
}

void read_layers(ByteReader bytes, char version, PenFile& content) {
  constexpr std::size_t least_layer = 4, least_line = 20;
  const std::size_t layers = bytes.count(bytes.take<std::uint32_t>(), least_layer);
  for (std::size_t layer = 1; layer <= layers; ++layer) {
    const std::size_t lines = bytes.count(bytes.take<std::uint32_t>(), least_line);
    for (std::size_t i = 0; i < lines; ++i) {
      PenStroke stroke = read_line(bytes, version);
      stroke.layer = layer;
      if (!stroke.samples.empty()) content.strokes.push_back(std::move(stroke));
    }
  }
}

}  // namespace

bool is_remarkable(std::string_view text) { return text.starts_with(head_text); }

PenFile read_remarkable(const PenFileText& file) {
  PenFile content;
  content.unit = "px";
  content.millimetres = 25.4 / 226;
  ByteReader bytes(file.text, file.path);
  const char version = bytes.take_bytes(head_size)[head_text.size()];
  if (version == '6')
    read_remarkable_blocks(bytes, content);
  else if (version == '3' || version == '5')
    read_layers(bytes, version, content);
  else
    bytes.reject("lines of a version that is not known; known are 3, 5 and 6");
  return content;
}

}  // namespace burin
