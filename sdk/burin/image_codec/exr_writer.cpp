// Encodes an image in memory with OpenImageIO and writes the file whole.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/image_codec/exr_writer.h>

namespace burin {
namespace {

OIIO::ImageSpec spec_of(const FloatImage& image) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()), OIIO::TypeFloat);
  spec.channelnames = image.channels;
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  // Without this attribute the library stores the time of writing, so that no two files would be equal.
  spec.attribute("DateTime", "");
  return spec;
}

}  // namespace

void write_exr_file(const std::filesystem::path& path, const FloatImage& image) {
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create("exr");
  if (!output) throw FileError(path.string(), OIIO::geterror());
  output->threads(1);
  if (!output->set_ioproxy(&bytes) || !output->open("image.exr", spec_of(image)) ||
      !output->write_image(OIIO::TypeFloat, image.texels.data()) || !output->close())
    throw FileError(path.string(), output->geterror());
  write_file_whole(path, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.buffer().data()),
              static_cast<std::streamsize>(bytes.buffer().size()));
  });
}

}  // namespace burin
