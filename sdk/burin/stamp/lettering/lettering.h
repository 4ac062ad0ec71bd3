#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace burin {

/// A line of text as an image of one channel: the part of each texel that letters cover. Lengths are in ems,
/// the size of the font; x runs to the right from where the line begins, y upward from its baseline.
struct Lettering {
  StampImage image;                ///< wrap black, with a margin of a few texels of 0
  float width;                     ///< of the line, kerning included: where more text would begin
  float ascent, descent;           ///< of the font above and below the baseline, both >= 0
  float left, right, bottom, top;  ///< borders of the image
};

constexpr std::uint32_t least_em = 8, greatest_em = 512;

/// Sets a line of UTF-8 text with the first face of a font file of outlines (TrueType, OpenType, their
/// collections): shaped and kerned as the font says, one direction a line, letters at fractions of a texel,
/// without hinting. `em`: texels to an em, least_em .. greatest_em.
/// Throws FileError: no font, no outlines, a character that the font lacks; Error: no text, no UTF-8, a
/// control character, more than 2^28 texels; ContractError: em out of range.
Lettering set_lettering(const std::filesystem::path& font, std::string_view text, std::uint32_t em);

}  // namespace burin
