// Takes the Ink Serialized Format out of what wraps it: base64, and the comments of a GIF.
#include <burin/base/error.h>
#include <burin/base/text/base64.h>
#include <burin/ink/decode/isf_stream.h>
#include <burin/ink/parse/byte_reader.h>
#include <burin/ink/parse/scan.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr std::string_view base64_head = "base64:";

/// Base64 as it stands in files: with line breaks, up to a zero.
std::string decoded(std::string_view text, const std::filesystem::path& path) {
  std::string letters(text.substr(0, text.find('\0')));
  std::erase_if(letters, [](char letter) { return blanks.find(letter) != blanks.npos; });
  std::optional<std::string> bytes = from_base64(letters);
  if (!bytes) throw FileError(path.string(), "a letter that is none of base64");
  return std::move(*bytes);
}

/// Appends the blocks up to the empty one to `to`, if that is not null.
void take_blocks(ByteReader& gif, std::string* to) {
  while (const auto length = gif.take<std::uint8_t>()) {
    const std::string_view block = gif.take_bytes(length);
    if (to) *to += block;
  }
}

/// The table of colours that follows where the flags say so.
void skip_colours(ByteReader& gif, std::uint8_t flags) {
  constexpr std::uint8_t has_table = 0x80, size_bits = 7;
  if (flags & has_table) gif.take_bytes(std::size_t{3} << ((flags & size_bits) + 1));
}

std::string comments_of(std::string_view bytes, const std::filesystem::path& path) {
  constexpr std::size_t signature = 6, screen_size = 4, image_place = 8;
  constexpr std::uint8_t extension = 0x21, comment = 0xFE, image = 0x2C;
  ByteReader gif(bytes, path);
  gif.take_bytes(signature + screen_size);
  const auto flags = gif.take<std::uint8_t>();
  gif.take_bytes(2);  // background and aspect
  skip_colours(gif, flags);
  std::string comments;
  while (!gif.empty()) {
    const auto block = gif.take<std::uint8_t>();
    if (block == extension) {
      take_blocks(gif, gif.take<std::uint8_t>() == comment ? &comments : nullptr);
    } else if (block == image) {
      gif.take_bytes(image_place);
      skip_colours(gif, gif.take<std::uint8_t>());
      gif.take_bytes(1);  // the size of its codes
      take_blocks(gif, nullptr);
    } else {
      break;
    }
  }
  return comments;
}

}  // namespace

std::string isf_stream(const PenFileText& file) {
  const std::string_view text = file.text;
  std::string bytes =
      text.starts_with(base64_head) ? decoded(text.substr(base64_head.size()), file.path) : std::string(text);
  if (!bytes.starts_with("GIF8")) return bytes;
  bytes = comments_of(bytes, file.path);
  if (bytes.empty())
    throw FileError(file.path.string(), "a GIF without a comment, which would have the strokes");
  return bytes;
}

}  // namespace burin
