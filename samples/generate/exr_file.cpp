// Writes EXR files of half floats.
#include "exr_file.h"

#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>

namespace burin::samples {

void write_exr(const std::filesystem::path& path, int width, int height,
               const std::vector<std::string>& channels, std::span<const float> texels) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::HALF);
  spec.channelnames = channels;
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "2000:01:01 00:00:00");  // fixed, so that the file is the same every time
  const auto out = OIIO::ImageOutput::create(path.string());
  if (!out || !out->open(path.string(), spec)) throw FileError(path.string(), OIIO::geterror());
  if (!out->write_image(OIIO::TypeDesc::FLOAT, texels.data()) || !out->close())
    throw FileError(path.string(), out->geterror());
}

}  // namespace burin::samples
