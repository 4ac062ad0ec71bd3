#include <burin/stamp/jpeg_size.h>

#include <cstddef>

namespace burin {

JpegSize jpeg_size(std::string_view bytes) {
  const auto byte = [&](std::size_t at) {
    return at < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[at])} : 0;
  };
  const auto word = [&](std::size_t at) { return byte(at) << 8 | byte(at + 1); };
  // Segments FF MARKER LENGTH ..., from behind the file's first marker on; fill bytes FF may stand between.
  for (std::size_t at = 2; at + 9 < bytes.size();) {
    if (byte(at) != 0xff) return {};
    const std::uint32_t marker = byte(at + 1);
    if (marker == 0xff) {
      ++at;
      continue;
    }
    // Frames of any kind, but not tables (C4, CC) nor an extension (C8).
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) return {word(at + 7), word(at + 5), byte(at + 9)};
    at += 2 + word(at + 2);
  }
  return {};
}

}  // namespace burin
