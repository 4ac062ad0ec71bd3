// Reads the markers of a JPEG file [ITU-T T.81].
#include <burin/image_codec/jpeg_size.h>

#include <cstddef>

namespace burin {
namespace {

/// The bytes of a file as numbers; bytes beyond its end are 0.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::size_t size() const { return bytes_.size(); }
  std::uint32_t byte(std::size_t at) const {
    return at < bytes_.size() ? std::uint32_t{static_cast<unsigned char>(bytes_[at])} : 0;
  }
  std::uint32_t word(std::size_t at) const { return byte(at) << 8 | byte(at + 1); }

 private:
  std::string_view bytes_;
};

constexpr std::uint32_t start_of_scan = 0xda, end_of_image = 0xd9;

/// Whether a marker begins a frame: C0 to CF except the tables C4 and CC and the extension C8.
bool begins_frame(std::uint32_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// The position of the next marker after compressed data, in which FF 00 is a byte FF and FF D0 to FF D7 are
/// restart markers.
std::size_t behind_scan(const Bytes& file, std::size_t at) {
  for (; at + 1 < file.size(); ++at) {
    const std::uint32_t next = file.byte(at + 1);
    const bool restart = next >= 0xd0 && next <= 0xd7;
    if (file.byte(at) == 0xff && next != 0 && next != 0xff && !restart) return at;
  }
  return file.size();
}

}  // namespace

JpegInfo jpeg_size(std::string_view bytes) {
  const Bytes file(bytes);
  JpegInfo size;
  // After the first marker the file consists of segments FF MARKER LENGTH ..., with fill bytes FF between
  // them.
  for (std::size_t at = 2; at + 1 < file.size() && file.byte(at) == 0xff;) {
    const std::uint32_t marker = file.byte(at + 1);
    if (marker == 0xff) {
      ++at;
      continue;
    }
    if (marker == end_of_image) {
      size.has_end = true;
      break;
    }
    if (begins_frame(marker) && size.components == 0) {
      size.width = file.word(at + 7);
      size.height = file.word(at + 5);
      size.components = file.byte(at + 9);
    }
    at += 2 + file.word(at + 2);
    if (marker == start_of_scan) at = behind_scan(file, at);
  }
  return size;
}

}  // namespace burin
