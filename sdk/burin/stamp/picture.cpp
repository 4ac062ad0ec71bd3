#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/picture.h>

namespace burin {
namespace {

/// The picture as the bytes of a PNG file; `path` is for messages.
std::vector<unsigned char> encode_png(const std::filesystem::path& path, const Picture& picture) {
  OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) throw FileError(path.string(), OIIO::geterror());
  output->threads(1);
  if (!output->set_ioproxy(&bytes) || !output->open("picture.png", spec) ||
      !output->write_image(OIIO::TypeUInt8, picture.rgb.data()) || !output->close())
    throw FileError(path.string(), output->geterror());
  return bytes.buffer();
}

}  // namespace

void write_png(const std::filesystem::path& path, const Picture& picture) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(picture.width, 0)) *
                             static_cast<std::size_t>(std::max(picture.height, 0));
  if (pixels == 0 || picture.rgb.size() != 3 * pixels)
    throw ContractError("write_png: the picture has no pixels, or another number of bytes than 3 a pixel");
  const std::vector<unsigned char> bytes = encode_png(path, picture);
  write_file_whole(path, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace burin
