#include "picture_file.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace burin::test {

Picture read_png(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw std::runtime_error("cannot open " + path.string());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.nchannels != 3 || input->format_name() != std::string("png"))
    throw std::runtime_error("no RGB PNG");
  Picture picture{spec.width, spec.height, {}};
  picture.rgb.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 3);
  if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data())) {
    throw std::runtime_error("cannot read " + path.string());
  }
  return picture;
}

Rgb pixel(const Picture& picture, int column, int row) {
  const std::size_t at = 3 * static_cast<std::size_t>(row * picture.width + column);
  return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

bool covered(const Picture& picture, int column, int row) {
  return pixel(picture, column, row) != pixel(picture, 0, row);
}

}  // namespace burin::test
