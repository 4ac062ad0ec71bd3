// Shapes a line of text with HarfBuzz.
#include <burin/base/error.h>
#include <burin/base/text/utf8.h>
#include <burin/stamp/lettering/shaped_line.h>
#include <fmt/format.h>
#include <harfbuzz/hb-ot.h>
#include <harfbuzz/hb.h>

#include <algorithm>
#include <memory>
#include <span>

namespace burin {
namespace {

template <auto Destroy>
struct Destroyer {
  template <class Object>
  void operator()(Object* object) const {
    Destroy(object);
  }
};
using Blob = std::unique_ptr<hb_blob_t, Destroyer<hb_blob_destroy>>;
using HbFace = std::unique_ptr<hb_face_t, Destroyer<hb_face_destroy>>;
using Font = std::unique_ptr<hb_font_t, Destroyer<hb_font_destroy>>;
using Buffer = std::unique_ptr<hb_buffer_t, Destroyer<hb_buffer_destroy>>;

void expect_line(std::string_view text) {
  if (text.empty()) throw Error("there is no text to set");
  if (text.size() > 16384) throw Error("the text is longer than a line of 16384 bytes");
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t at = text.size() - rest.size();
    const auto code = pop_code_point(rest);
    if (!code) throw Error(fmt::format("the text is no UTF-8 at byte {}", at));
    if (is_control(*code))
      throw Error(fmt::format("the text is no single line: it holds U+{:04X} at byte {}",
                              static_cast<std::uint32_t>(*code), at));
  }
}

Font open_font(const std::filesystem::path& path, std::string_view bytes) {
  const Blob blob(hb_blob_create(bytes.data(), static_cast<unsigned>(bytes.size()), HB_MEMORY_MODE_READONLY,
                                 nullptr, nullptr));
  const HbFace face(hb_face_create(blob.get(), 0));
  if (hb_face_get_glyph_count(face.get()) == 0) throw FileError(path.string(), "is no font");
  return Font(hb_font_create(face.get()));
}

Buffer shaped(hb_font_t* font, std::string_view text) {
  Buffer buffer(hb_buffer_create());
  const int size = static_cast<int>(text.size());
  hb_buffer_add_utf8(buffer.get(), text.data(), size, 0, size);
  // The library would guess the language from the user's locale; "und" makes text look the same everywhere.
  hb_buffer_set_language(buffer.get(), hb_language_from_string("und", -1));
  hb_buffer_guess_segment_properties(buffer.get());
  hb_shape(font, buffer.get(), nullptr, 0);
  if (!hb_buffer_allocation_successful(buffer.get())) throw std::bad_alloc();
  return buffer;
}

[[noreturn]] void refuse_character(const std::filesystem::path& path, std::string_view text, std::size_t at) {
  std::string_view rest = text.substr(at);
  const auto code = pop_code_point(rest);
  const std::string_view character = text.substr(at, text.size() - at - rest.size());
  throw FileError(path.string(), fmt::format("the font has no glyph for '{}' (U+{:04X})", character,
                                             static_cast<std::uint32_t>(code.value_or(0xfffd))));
}

void read_metrics(hb_font_t* font, ShapedLine& line) {
  line.units_per_em = std::max(hb_face_get_upem(hb_font_get_face(font)), 1u);
  hb_font_extents_t extents{};
  hb_font_get_h_extents(font, &extents);
  line.ascent = std::max<std::int64_t>(extents.ascender, 0);
  line.descent = std::max<std::int64_t>(-std::int64_t{extents.descender}, 0);
}

}  // namespace

ShapedLine shape_line(const std::filesystem::path& path, std::string_view font_bytes, std::string_view text) {
  expect_line(text);
  const Font font = open_font(path, font_bytes);
  const Buffer buffer = shaped(font.get(), text);
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(buffer.get(), &count);
  ShapedLine line;
  read_metrics(font.get(), line);
  std::int64_t y = 0;
  for (const hb_glyph_info_t& info : std::span(infos, count)) {
    if (info.codepoint == 0) refuse_character(path, text, info.cluster);
    line.glyphs.push_back({info.codepoint, line.width + position->x_offset, y + position->y_offset});
    line.width += position->x_advance;
    y += position->y_advance;
    ++position;
  }
  return line;
}

}  // namespace burin
