#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/stamp/bilinear.h>
#include <burin/stamp/stamp_image.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

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
  auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw FileError(path.string(), one_line(OIIO::geterror()));
  input->threads(1);
  return input;
}

void expect_stamp(const std::string& path, const OIIO::ImageInput& input) {
  const OIIO::ImageSpec& spec = input.spec();
  for (int c = 0; c < spec.nchannels; ++c)
    if (const OIIO::TypeDesc type = spec.channelformat(c); !type.is_floating_point())
      throw FileError(path,
                      fmt::format("channel {} holds whole numbers ({}); a stamp is an EXR image of half or "
                                  "float texels",
                                  spec.channel_name(c), type.c_str()));
  if (std::string_view(input.format_name()) != "openexr")
    throw FileError(path, fmt::format("is an image of the format {}, not EXR", input.format_name()));
  if (spec.deep) throw FileError(path, "holds deep texels; a stamp has one value a texel and channel");
  const auto values = [&](int width, int height) {
    return static_cast<double>(width) * height * spec.nchannels;
  };
  if (values(spec.full_width, spec.full_height) < 1) throw FileError(path, "holds no texels");
  if (std::max(values(spec.width, spec.height), values(spec.full_width, spec.full_height)) > most_values)
    throw FileError(path, "is too large: a stamp holds at most 2^28 values");
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

void expect_finite(const std::string& path, const StampImage& image, const OIIO::ImageSpec& spec) {
  const auto bad = std::find_if_not(image.texels.begin(), image.texels.end(),
                                    [](float value) { return std::isfinite(value); });
  if (bad == image.texels.end()) return;
  const auto at = bad - image.texels.begin();
  const auto texel = at / image.channels;
  throw FileError(
      path,
      fmt::format("channel {}, x {}, y {}", spec.channel_name(static_cast<int>(at % image.channels)),
                  texel % image.width, texel / image.width),
      fmt::format("the texel is not finite ({})", *bad));
}

}  // namespace

void set_range(StampImage& image) {
  image.minimum = std::numeric_limits<float>::infinity();
  image.maximum = -image.minimum;
  for (std::size_t i = 0; i < image.texels.size(); i += static_cast<std::size_t>(image.channels)) {
    image.minimum = std::min(image.minimum, image.texels[i]);
    image.maximum = std::max(image.maximum, image.texels[i]);
  }
}

StampImage read_stamp(const std::filesystem::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open(path);
  expect_stamp(path.string(), *input);
  const OIIO::ImageSpec spec = input->spec();
  StampImage image;
  image.width = spec.full_width;
  image.height = spec.full_height;
  image.channels = spec.nchannels;
  image.texels = display_window(spec, read_data_window(path.string(), *input));
  expect_finite(path.string(), image, spec);
  set_range(image);
  return image;
}

float sample_bilinear(const StampImage& image, int channel, float u, float v) {
  if (!std::isfinite(u) || !std::isfinite(v)) return std::numeric_limits<float>::quiet_NaN();
  return bilinear(image, channel, in_period(u), in_period(v));
}

}  // namespace burin
