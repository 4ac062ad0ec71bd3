#include "image_seeds.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>

namespace burin::fuzz {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageSpec;

constexpr int width = 20, height = 12;

ImageSpec spec_of(int channels, OIIO::TypeDesc type, const std::string& compression = {}) {
  ImageSpec spec(width, height, channels, type);
  if (!compression.empty()) spec.attribute("compression", compression);
  return spec;
}

ImageSpec tiled(ImageSpec spec) {
  spec.tile_width = spec.tile_height = 16;
  return spec;
}

ImageSpec with(ImageSpec spec, const std::string& name, int value) {
  spec.attribute(name, value);
  return spec;
}

std::vector<ImageSpec> exr_specs() {
  std::vector<ImageSpec> specs;
  for (const char* compression : {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "dwaa"})
    specs.push_back(spec_of(3, OIIO::TypeHalf, compression));
  specs.push_back(tiled(spec_of(1, OIIO::TypeFloat, "zip")));
  specs.push_back(spec_of(4, OIIO::TypeFloat, "piz"));
  specs.back().channelnames = {"disp.R", "disp.G", "disp.B", "disp.A"};
  ImageSpec window = spec_of(1, OIIO::TypeFloat, "none");
  window.full_width = 2 * width;
  window.full_x = -3;
  specs.push_back(window);
  return specs;
}

std::vector<ImageSpec> tiff_specs() {
  std::vector<ImageSpec> specs;
  for (const char* compression : {"none", "lzw", "zip", "packbits"})
    specs.push_back(spec_of(1, OIIO::TypeUInt16, compression));
  specs.push_back(tiled(spec_of(3, OIIO::TypeFloat, "zip")));
  specs.push_back(with(spec_of(1, OIIO::TypeUInt8, "none"), "Orientation", 6));
  specs.push_back(with(spec_of(1, OIIO::TypeUInt8, "none"), "tiff:bilevel", 1));
  return specs;
}

std::vector<ImageSpec> specs_for(const std::string& extension) {
  if (extension == ".exr") return exr_specs();
  if (extension == ".tif") return tiff_specs();
  if (extension == ".jpg")
    return {spec_of(1, OIIO::TypeUInt8), with(spec_of(3, OIIO::TypeUInt8), "Orientation", 8)};
  return {spec_of(1, OIIO::TypeUInt8), spec_of(2, OIIO::TypeUInt16), spec_of(3, OIIO::TypeUInt16),
          with(spec_of(4, OIIO::TypeUInt8), "Orientation", 3)};
}

void write(const fs::path& file, const ImageSpec& spec) {
  std::vector<float> values(static_cast<std::size_t>(width * height * spec.nchannels));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * i % 97) / 96;
  const auto output = OIIO::ImageOutput::create(file.string());
  if (!output || !output->open(file.string(), spec) || !output->write_image(OIIO::TypeFloat, values.data()))
    throw std::runtime_error("cannot write " + file.string());
  output->close();
}

}  // namespace

std::vector<fs::path> write_image_seeds(const std::string& extension, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const ImageSpec& spec : specs_for(extension)) {
    files.push_back(folder / ("image" + std::to_string(files.size()) + extension));
    write(files.back(), spec);
  }
  return files;
}

}  // namespace burin::fuzz
