// Encodes an image in memory and writes the file whole.
#include <OpenImageIO/filesystem.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/stamp/files/encode_image.h>

namespace burin {

void write_encoded(const std::filesystem::path& path, const char* format, const OIIO::ImageSpec& spec,
                   const void* texels) {
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) throw FileError(path.string(), OIIO::geterror());
  output->threads(1);
  if (!output->set_ioproxy(&bytes) || !output->open(std::string("image.") + format, spec) ||
      !output->write_image(spec.format, texels) || !output->close())
    throw FileError(path.string(), output->geterror());
  write_file_whole(path, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.buffer().data()),
              static_cast<std::streamsize>(bytes.buffer().size()));
  });
}

}  // namespace burin
