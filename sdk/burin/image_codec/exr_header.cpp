// Reads the headers of an EXR file as OpenEXR lays them out, to check their sizes before the library
// allocates.
#include <burin/base/error.h>
#include <burin/image_codec/exr_header.h>
#include <burin/stamp/files/image_limits.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

namespace burin {
namespace {

/// Reads the numbers of a header, which are little-endian, and its zero-terminated texts.
class HeaderReader {
 public:
  explicit HeaderReader(const std::filesystem::path& path)
      : path_(path.string()), in_(path, std::ios::binary) {}

  std::uint32_t number() {
    std::uint32_t number = 0;
    for (int shift = 0; shift < 32; shift += 8) number |= std::uint32_t{byte()} << shift;
    return number;
  }

  std::string text() {
    constexpr std::size_t longest = 255;
    std::string text;
    for (std::uint8_t c = byte(); c != 0; c = byte()) {
      if (text.size() == longest) fail();
      text.push_back(static_cast<char>(c));
    }
    return text;
  }

  std::uint8_t byte() {
    const int c = in_.get();
    if (c == std::char_traits<char>::eof()) fail();
    return static_cast<std::uint8_t>(c);
  }

  std::streamoff at() { return in_.tellg(); }
  void go_to(std::streamoff place) { in_.seekg(place); }

  [[noreturn]] void fail(const char* what = "has no end") const {
    throw FileError(path_, std::string("is damaged: its header ") + what);
  }

 private:
  std::string path_;
  std::ifstream in_;
};

/// The sizes of one part (image) of the file.
struct PartSizes {
  std::uint64_t width = 0, height = 0, tile_width = 0, tile_height = 0, channels = 1, chunks = 0;
  std::uint8_t compression = 0;

  /// The number of rows of a chunk in a part without tiles, by its compression.
  std::uint64_t rows() const {
    constexpr std::uint64_t rows[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    return rows[std::min<std::size_t>(compression, std::size(rows) - 1)];
  }
};

std::uint64_t extent(std::uint32_t least, std::uint32_t greatest) {
  const std::int64_t size =
      std::int64_t{static_cast<std::int32_t>(greatest)} - static_cast<std::int32_t>(least) + 1;
  return static_cast<std::uint64_t>(std::max<std::int64_t>(size, 1));
}

std::uint64_t count_channels(HeaderReader& in) {
  std::uint64_t channels = 0;
  while (!in.text().empty()) {
    ++channels;
    for (int words = 0; words < 4; ++words) in.number();
  }
  return channels;
}

void read_value(HeaderReader& in, const std::string& name, const std::string& type, PartSizes& part) {
  if (name == "dataWindow" && type == "box2i") {
    const std::uint32_t left = in.number(), top = in.number(), right = in.number(), bottom = in.number();
    part.width = extent(left, right);
    part.height = extent(top, bottom);
  } else if (name == "tiles" && type == "tiledesc") {
    part.tile_width = std::max(in.number(), 1U);
    part.tile_height = std::max(in.number(), 1U);
  } else if (name == "compression" && type == "compression") {
    part.compression = in.byte();
  } else if (name == "channels" && type == "chlist") {
    part.channels = count_channels(in);
  } else if (name == "chunkCount" && type == "int") {
    part.chunks = in.number();
  }
}

/// The size of a value of this type in bytes, or 0 if the type has no fixed size.
std::uint32_t size_of(const std::string& type) {
  constexpr std::pair<const char*, std::uint32_t> sizes[] = {{"box2f", 16},
                                                             {"box2i", 16},
                                                             {"chromaticities", 32},
                                                             {"compression", 1},
                                                             {"deepImageState", 1},
                                                             {"double", 8},
                                                             {"envmap", 1},
                                                             {"float", 4},
                                                             {"int", 4},
                                                             {"keycode", 28},
                                                             {"lineOrder", 1},
                                                             {"m33d", 72},
                                                             {"m33f", 36},
                                                             {"m44d", 128},
                                                             {"m44f", 64},
                                                             {"rational", 8},
                                                             {"tiledesc", 9},
                                                             {"timecode", 8},
                                                             {"v2d", 16},
                                                             {"v2f", 8},
                                                             {"v2i", 8},
                                                             {"v3d", 24},
                                                             {"v3f", 12},
                                                             {"v3i", 12}};
  const auto found =
      std::ranges::find(sizes, type, [](const auto& entry) { return std::string(entry.first); });
  return found == std::end(sizes) ? 0 : found->second;
}

/// Checks that the sizes inside an attribute of variable size (a preview image, a list of texts or of
/// channels) add up to the attribute's size. The library reads such values by their content and continues
/// where they end, whatever size the file states.
void expect_inner_sizes(HeaderReader& in, const std::string& type, std::uint64_t size) {
  const std::streamoff begin = in.at();
  std::uint64_t used = size;
  if (type == "preview") {
    const std::uint64_t width = in.number(), height = in.number();
    used = 8 + 4 * std::min<std::uint64_t>(width, size) * std::min<std::uint64_t>(height, size);
  } else if (type == "stringvector") {
    for (used = 0; used < size; in.go_to(begin + static_cast<std::streamoff>(used))) used += 4 + in.number();
  } else if (type == "chlist") {
    count_channels(in);
    used = static_cast<std::uint64_t>(in.at() - begin);
  }
  if (used != size) in.fail("has an attribute of a wrong size");
  in.go_to(begin);
}

/// Reads the attributes of one part, up to the empty name that ends them. Returns false if there are none,
/// which ends the headers of a file of several parts.
bool read_part(HeaderReader& in, std::uint64_t file_bytes, PartSizes& part) {
  bool any = false;
  for (std::string name = in.text(); !name.empty(); name = in.text(), any = true) {
    const std::string type = in.text();
    const std::uint32_t size = in.number();
    const std::streamoff begin = in.at();
    if (size > file_bytes - static_cast<std::uint64_t>(begin)) in.fail();
    if (const std::uint32_t fixed = size_of(type); fixed > 0 && size != fixed)
      in.fail("has an attribute of a wrong size");
    expect_inner_sizes(in, type, size);
    read_value(in, name, type, part);
    in.go_to(begin + size);
  }
  return any;
}

void expect_part(const std::string& path, const PartSizes& part, std::uint64_t file_bytes) {
  const bool tiled = part.tile_width > 0;
  const std::uint64_t across = tiled ? (part.width + part.tile_width - 1) / part.tile_width : 1;
  const std::uint64_t rows = tiled ? part.tile_height : part.rows();
  const std::uint64_t chunks = std::max(across * ((part.height + rows - 1) / rows), part.chunks);
  constexpr std::uint64_t bytes_a_place = 8;
  check_stamp_size(path, part.width, part.height, 1, file_bytes);
  check_stamp_size(path, tiled ? part.tile_width : part.width, rows, part.channels, file_bytes);
  if (chunks > file_bytes / bytes_a_place)
    throw FileError(path, "is cut off: it tells of more chunks than it has room for");
}

}  // namespace

void check_exr_header(const std::filesystem::path& path, std::uint64_t file_bytes) {
  constexpr std::uint32_t several_parts = 0x1000;
  HeaderReader in(path);
  in.number();
  const bool several = (in.number() & several_parts) != 0;
  for (PartSizes part; read_part(in, file_bytes, part); part = {}) {
    expect_part(path.string(), part, file_bytes);
    if (!several) break;
  }
}

}  // namespace burin
