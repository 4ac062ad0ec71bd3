// Writes PNG files with libpng.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/files/picture.h>
#include <png.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

/// The bytes of a PNG file. The library ends writing with a message on errors, such as too little memory.
std::string encoded(const std::filesystem::path& path, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  const bool done =
      png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) != 0;
  if (!done) throw FileError(path.string(), image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgb.size() != 3 * pixels)
    throw ContractError("write_png: the picture has no pixels, or another number of bytes than 3 a pixel");
  const std::string bytes = encoded(path, picture);
  write_file_whole(
      path, [&](std::ostream& out) { out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); });
}

}  // namespace burin
