#include "picture_file.h"

#include <png.h>

#include <stdexcept>

namespace burin::test {

Picture read_png(const std::filesystem::path& path) {
  png_image file{};
  file.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&file, path.c_str()))
    throw std::runtime_error("cannot open " + path.string());
  if (file.format != PNG_FORMAT_RGB) throw std::runtime_error("no RGB PNG");
  Picture picture{static_cast<int>(file.width), static_cast<int>(file.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(file));
  if (!png_image_finish_read(&file, nullptr, picture.rgb.data(), 0, nullptr))
    throw std::runtime_error("cannot read " + path.string());
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
