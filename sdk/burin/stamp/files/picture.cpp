// Writes PNG files.
#include <burin/base/error.h>
#include <burin/stamp/files/encode_image.h>
#include <burin/stamp/files/picture.h>

namespace burin {

void write_png(const std::filesystem::path& path, const Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgb.size() != 3 * pixels)
    throw ContractError("write_png: the picture has no pixels, or another number of bytes than 3 a pixel");
  OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write_encoded(path, "png", spec, picture.rgb.data());
}

}  // namespace burin
