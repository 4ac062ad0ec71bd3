// Parses ZBrush's colours and masks in the comments of an OBJ file, in one pass over the text.
#include <burin/surface/files/text_lines.h>
#include <burin/surface/formats/obj_polypaint.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace burin {

ObjPolypaint::ObjPolypaint(std::string_view text) {
  constexpr std::string_view mark = "#MRGB";
  if (text.find(mark) == std::string_view::npos) return;
  TextLines lines(text);
  while (auto line = lines.next()) {
    if (next_word(*line) == mark) read_line(next_word(*line));
  }
  if (std::ranges::all_of(paint_.masks, [](float mask) { return mask == 1; })) paint_.masks.clear();
}

void ObjPolypaint::read_line(std::string_view digits) {
  constexpr std::size_t of_vertex = 8;
  ++lines_;
  sound_ = sound_ && digits.size() % of_vertex == 0;
  for (std::size_t i = 0; sound_ && i < digits.size(); i += of_vertex) {
    std::uint32_t value = 0;
    const char *begin = digits.data() + i, *end = begin + of_vertex;
    sound_ = std::from_chars(begin, end, value, 16).ptr == end;
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift); };
    paint_.masks.push_back(static_cast<float>(byte(24)) / 255);
    paint_.colours.push_back({byte(16), byte(8), byte(0), 255});
  }
}

}  // namespace burin
