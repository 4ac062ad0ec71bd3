#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace burin {

/// A line of text as an image of one channel: the share of each texel that letters cover. Lengths are in ems,
/// the size of the font; x runs to the right from the start of the line, y upward from its baseline.
struct Lettering {
  StampImage image;       ///< wrap black, with a margin of 4 texels of 0
  float width;            ///< advance width of the line, kerning included: more text would start there
  float ascent, descent;  ///< of the font above and below the baseline, both >= 0
  float left, right, bottom, top;  ///< borders of the image
};

/// The range of sizes of an em, texels.
constexpr std::uint32_t min_em = 8, max_em = 512;

/// Sets a line of UTF-8 text with the first face of an outline font file (TrueType, OpenType or a collection
/// of these). The text is shaped and kerned by the font's tables, has one direction, and letters stand at
/// fractions of a texel without hinting. `em`: texels per em, min_em .. max_em.
/// Throws FileError if the file is not a font, has no outlines or lacks a character; Error if the text is
/// empty, not UTF-8, has a control character or needs more than 2^28 texels; ContractError if em is out of
/// range.
Lettering set_lettering(const std::filesystem::path& font, std::string_view text, std::uint32_t em);

}  // namespace burin
