#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/stamp/clean.h>
#include <burin/stamp/stamp_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

namespace burin {
namespace {

constexpr std::uint64_t most_values = std::uint64_t{1} << 28;

/// The library's complaint as one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "not readable as an image" : text;
}

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw FileError(path.string(), error.message());
  if (size == 0) throw FileError(path.string(), "is empty");
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path.string(), &hints);
  if (!input) throw FileError(path.string(), one_line(OIIO::geterror()));
  input->threads(1);
  return input;
}

void expect_texels(const std::string& path, const OIIO::ImageSpec& spec) {
  if (spec.deep) throw FileError(path, "holds deep texels; a stamp has one value a texel and channel");
  constexpr std::array known = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT16,
                                OIIO::TypeDesc::UINT8};
  for (int c = 0; c < spec.nchannels; ++c)
    if (const OIIO::TypeDesc type = spec.channelformat(c); !std::ranges::count(known, type.basetype))
      throw FileError(path, fmt::format("channel {} holds texels of type {}; those of a stamp are half, "
                                        "float, uint16 or uint8",
                                        spec.channel_name(c), type.c_str()));
  if (spec.nchannels != 1 && spec.nchannels != 3 && spec.nchannels != 4)
    throw FileError(path, fmt::format("has {} channels; a stamp has 1, 3 or 4", spec.nchannels));
}

void expect_size(const std::string& path, const OIIO::ImageSpec& spec) {
  const auto values = [&](int width, int height) {
    return static_cast<double>(width) * height * spec.nchannels;
  };
  if (spec.full_depth > 1 || spec.depth > 1) throw FileError(path, "holds a volume, not an image");
  if (values(spec.full_width, spec.full_height) < 1) throw FileError(path, "holds no texels");
  if (std::max(values(spec.width, spec.height), values(spec.full_width, spec.full_height)) > most_values)
    throw FileError(path, "is too large: a stamp holds at most 2^28 values");
}

void expect_stamp(const std::string& path, OIIO::ImageInput& input) {
  constexpr std::array<std::string_view, 4> formats = {"openexr", "tiff", "png", "jpeg"};
  if (!std::ranges::count(formats, input.format_name()))
    throw FileError(path, fmt::format("is an image of the format {}; a stamp is EXR, TIFF, PNG or JPEG",
                                      input.format_name()));
  const OIIO::ImageSpec spec = input.spec();
  expect_texels(path, spec);
  expect_size(path, spec);
  if (input.seek_subimage(1, 0)) throw FileError(path, "holds several parts; a stamp is one image");
  input.seek_subimage(0, 0);
}

std::vector<float> read_data_window(const std::string& path, OIIO::ImageInput& input) {
  const OIIO::ImageSpec spec = input.spec();
  std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.data()))
    throw FileError(path, one_line(input.geterror()));
  return values;
}

/// The part of the data window that lies in the display window, in its place.
std::vector<float> display_window(const OIIO::ImageSpec& spec, std::vector<float> data) {
  if (spec.roi() == spec.roi_full()) return data;
  const std::int64_t left = std::int64_t{spec.x} - spec.full_x, top = std::int64_t{spec.y} - spec.full_y;
  const std::int64_t x_begin = std::max<std::int64_t>(left, 0);
  const std::int64_t x_end = std::min<std::int64_t>(left + spec.width, spec.full_width);
  const std::int64_t y_begin = std::max<std::int64_t>(top, 0);
  const std::int64_t y_end = std::min<std::int64_t>(top + spec.height, spec.full_height);
  const std::int64_t channels = spec.nchannels;
  std::vector<float> display(static_cast<std::size_t>(channels * spec.full_width * spec.full_height));
  if (x_begin >= x_end) return display;
  for (std::int64_t y = y_begin; y < y_end; ++y)
    std::copy_n(data.begin() + ((y - top) * spec.width + x_begin - left) * channels,
                (x_end - x_begin) * channels, display.begin() + (y * spec.full_width + x_begin) * channels);
  return display;
}

StampFile describe(OIIO::ImageInput& input) {
  const OIIO::ImageSpec spec = input.spec();
  StampFile file;
  file.format = input.format_name();
  file.texel_type = spec.format.c_str();
  file.compression = spec.get_string_attribute("compression");
  file.channels = spec.channelnames;
  file.tile_width = spec.tile_width;
  file.tile_height = spec.tile_height;
  while (input.seek_subimage(0, file.mip_levels)) ++file.mip_levels;
  input.seek_subimage(0, 0);
  file.data_x = spec.x - spec.full_x;
  file.data_y = spec.y - spec.full_y;
  file.data_width = spec.width;
  file.data_height = spec.height;
  std::tie(file.wrap_u, file.wrap_v) = wraps_named(spec.get_string_attribute("wrapmodes").c_str());
  return file;
}

void expect_finite(const std::string& path, const StampImage& image, const StampFile& file) {
  const auto bad = std::find_if_not(image.texels.begin(), image.texels.end(),
                                    [](float value) { return std::isfinite(value); });
  if (bad == image.texels.end()) return;
  const auto at = bad - image.texels.begin();
  const auto texel = at / image.channels;
  throw FileError(
      path,
      fmt::format("channel {}, x {}, y {}", file.channels[static_cast<std::size_t>(at % image.channels)],
                  texel % image.width, texel / image.width),
      fmt::format("the texel is not finite ({})", *bad));
}

Wrap chosen(Wrap option, Wrap of_file) {
  if (option != Wrap::unknown) return option;
  return of_file != Wrap::unknown ? of_file : Wrap::periodic;
}

}  // namespace

StampImage read_stamp(const std::filesystem::path& path, const StampOptions& options, StampFile* file) {
  const std::unique_ptr<OIIO::ImageInput> input = open(path);
  expect_stamp(path.string(), *input);
  StampFile described = describe(*input);
  const OIIO::ImageSpec spec = input->spec();
  StampImage image;
  image.width = spec.full_width;
  image.height = spec.full_height;
  image.channels = spec.nchannels;
  image.texels = display_window(spec, read_data_window(path.string(), *input));
  image.wrap_u = chosen(options.wrap_u, described.wrap_u);
  image.wrap_v = chosen(options.wrap_v, described.wrap_v);
  if (options.clean) described.not_finite = fill_not_finite(image);
  expect_finite(path.string(), image, described);
  set_range(image);
  if (file) *file = std::move(described);
  return image;
}

}  // namespace burin
