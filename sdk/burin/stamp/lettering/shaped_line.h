#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace burin {

/// A glyph of a line and the position of its origin in font units: x to the right from the start of the line,
/// y upward from the baseline.
struct PlacedGlyph {
  std::uint32_t glyph;
  std::int64_t x, y;
};

/// The glyphs of a line of text. Lengths are in font units.
struct ShapedLine {
  std::vector<PlacedGlyph> glyphs;  ///< from left to right
  std::int64_t width = 0;           ///< advance width
  std::int64_t ascent = 0, descent = 0;
  std::uint32_t units_per_em = 1;
};

/// Selects and positions the glyphs for a line of UTF-8 text by the tables of a font, kerning and ligatures
/// included. `font`: the bytes of the file at `path`. Throws the same errors as set_lettering().
ShapedLine shape_line(const std::filesystem::path& path, std::string_view font, std::string_view text);

}  // namespace burin
