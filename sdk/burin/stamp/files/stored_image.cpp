// Tells the format of an image file by its first bytes, and reads it with libpng or the image codec.
#include <burin/base/error.h>
#include <burin/stamp/files/chosen_channels.h>
#include <burin/stamp/files/image_codec.h>
#include <burin/stamp/files/png_reader.h>
#include <burin/stamp/files/stored_image.h>

#include <array>
#include <fstream>
#include <string_view>
#include <utility>

namespace burin {
namespace {

namespace fs = std::filesystem;

/// The format of a file by its first bytes, whatever its name: "openexr", "tiff", "png" or "jpeg".
const char* format_of(const fs::path& path, std::uintmax_t size) {
  if (size == 0) throw FileError(path.string(), "is empty");
  std::array<char, 4> first{};
  std::ifstream(path, std::ios::binary).read(first.data(), first.size());
  const std::string_view magic(first.data(), first.size());
  constexpr std::array<std::pair<std::string_view, const char*>, 7> formats = {
      {{"\x76\x2f\x31\x01", "openexr"},
       {"\x89PNG", "png"},
       {"\xff\xd8\xff", "jpeg"},
       {std::string_view("II\x2a\0", 4), "tiff"},
       {std::string_view("MM\0\x2a", 4), "tiff"},
       {std::string_view("II\x2b\0", 4), "tiff"},
       {std::string_view("MM\0\x2b", 4), "tiff"}}};
  for (const auto& [begin, name] : formats)
    if (magic.starts_with(begin)) return name;
  throw FileError(path.string(), "is no EXR, TIFF, PNG or JPEG image");
}

std::vector<std::string> png_channel_names(std::size_t channels) {
  const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  return names[channels - 1];
}

StoredImage read_png(const fs::path& path, const StampOptions& options) {
  PngImage png = read_png_numbers(path);
  const ChosenChannels chosen = chosen_channels(path.string(), {png_channel_names(png.channels)}, options);
  StoredImage stored;
  stored.image.width = stored.file.data_width = static_cast<int>(png.width);
  stored.image.height = stored.file.data_height = static_cast<int>(png.height);
  stored.image.channels = static_cast<int>(chosen.channels.size());
  stored.image.texels = texels_of(chosen.channels, std::move(png.texels), png.channels);
  stored.file.format = "png";
  stored.file.texel_type = png.words ? "uint16" : "uint8";
  stored.file.channels = chosen.names;
  stored.file.unused = chosen.unused;
  stored.file.orientation = png.orientation;
  return stored;
}

}  // namespace

StoredImage read_stored_image(const fs::path& path, const StampOptions& options) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) throw FileError(path.string(), "is not a file");
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error) throw FileError(path.string(), error.message());
  const std::string_view format = format_of(path, bytes);
  return format == "png" ? read_png(path, options) : image_codec().read({path, format, bytes}, options);
}

}  // namespace burin
