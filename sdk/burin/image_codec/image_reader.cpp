// Reads images with OpenImageIO, after checks of sizes that the library lacks.
#include <OpenImageIO/imageio.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/quoted_word.h>
#include <burin/image_codec/exr_header.h>
#include <burin/image_codec/image_reader.h>
#include <burin/image_codec/jpeg_size.h>
#include <burin/image_codec/tiff_facts.h>
#include <burin/stamp/files/chosen_channels.h>
#include <burin/stamp/files/image_limits.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// One image of a file. EXR files have one or more, called parts.
struct Part {
  int index = 0;
  OIIO::ImageSpec spec;
};

/// An open EXR, TIFF or JPEG file.
class ImageFile {
 public:
  explicit ImageFile(const ImageFileFormat& file)
      : path_(file.path.string()),
        format_(file.name),
        bytes_(file.size),
        input_(OIIO::ImageInput::create(format_)) {
    OIIO::ImageSpec hints, first;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    if (!input_) fail(OIIO::geterror());
    input_->threads(1);
    if (!input_->open(path_, first, hints)) fail(input_->geterror());
  }

  std::vector<Part> parts() {
    std::vector<Part> parts;
    constexpr int most = 1000;
    while (static_cast<int>(parts.size()) < most && input_->seek_subimage(static_cast<int>(parts.size()), 0))
      parts.push_back({static_cast<int>(parts.size()), input_->spec()});
    if (format_ != "openexr") parts.resize(1);
    return parts;
  }

  int count_mip_levels(const Part& part) {
    // If the library is asked for a missing level of a part other than the current one, it reads zeros
    // afterwards.
    input_->seek_subimage(part.index, 0);
    int levels = 1;
    while (input_->seek_subimage(part.index, levels)) ++levels;
    return levels;
  }

  /// Reads the channels `first` to `last` of a part, interleaved.
  std::vector<float> read(const Part& part, int first, int last) {
    std::vector<float> values(part.spec.image_pixels() * static_cast<std::size_t>(last + 1 - first));
    if (!input_->read_image(part.index, 0, first, last + 1, OIIO::TypeFloat, values.data()))
      fail(input_->geterror());
    return values;
  }

  const std::string& path() const { return path_; }
  std::string_view format() const { return format_; }
  std::uintmax_t bytes() const { return bytes_; }

 private:
  /// Throws the library's error message as one line.
  [[noreturn]] void fail(std::string text) const {
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw FileError(path_, text.empty() ? "not readable as an image" : printable(text));
  }

  const std::string path_, format_;
  const std::uintmax_t bytes_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

/// [part] the names of its channels. If there are several parts, names start with the name of their part.
std::vector<std::vector<std::string>> channel_names(const std::vector<Part>& parts) {
  std::vector<std::vector<std::string>> names(parts.size());
  for (const Part& part : parts) {
    const std::string prefix = std::string(part.spec.get_string_attribute("oiio:subimagename")) + ".";
    for (const std::string& name : part.spec.channelnames)
      names[static_cast<std::size_t>(part.index)].push_back(
          parts.size() == 1 || name.starts_with(prefix) ? name : prefix + name);
  }
  return names;
}

void expect_texels(const std::string& path, const OIIO::ImageSpec& spec, const std::vector<int>& channels,
                   std::string_view format) {
  if (spec.deep) throw FileError(path, "holds deep texels; a stamp has one value a texel and channel");
  if (spec.full_depth > 1 || spec.depth > 1) throw FileError(path, "holds a volume, not an image");
  using Type = OIIO::TypeDesc;
  std::vector<unsigned char> known = {Type::HALF, Type::FLOAT};
  if (format != "openexr")
    known.insert(known.end(),
                 {Type::UINT8, Type::UINT16, Type::INT16, Type::UINT32, Type::INT32, Type::DOUBLE});
  for (const int c : channels)
    if (const Type type = spec.channelformat(c); !std::ranges::count(known, type.basetype))
      throw FileError(path, fmt::format("channel {} holds texels of type {}, which no stamp is made of",
                                        quoted_word(spec.channel_name(c)), type.c_str()));
}

/// Removes the offset of an image that is not EXR and does not state the size of a whole picture: TIFF's page
/// offset is a position on paper, not a data window.
void set_window(OIIO::ImageSpec& spec, std::string_view format) {
  const bool whole = spec.full_width == spec.width && spec.full_height == spec.height;
  if (format != "openexr" && whole) spec.x = spec.y = spec.full_x = spec.full_y = 0;
}

/// The display window of an image: the data window where they overlap, else 0.
std::vector<float> display_window(const OIIO::ImageSpec& spec, std::int64_t channels,
                                  std::vector<float> data) {
  if (spec.roi() == spec.roi_full()) return data;
  const std::int64_t left = std::int64_t{spec.x} - spec.full_x, top = std::int64_t{spec.y} - spec.full_y;
  const std::int64_t x_begin = std::max<std::int64_t>(left, 0);
  const std::int64_t x_end = std::min<std::int64_t>(left + spec.width, spec.full_width);
  const std::int64_t y_begin = std::max<std::int64_t>(top, 0);
  const std::int64_t y_end = std::min<std::int64_t>(top + spec.height, spec.full_height);
  std::vector<float> display(static_cast<std::size_t>(channels * spec.full_width * spec.full_height));
  if (x_begin >= x_end) return display;
  for (std::int64_t y = y_begin; y < y_end; ++y)
    std::copy_n(data.begin() + ((y - top) * spec.width + x_begin - left) * channels,
                (x_end - x_begin) * channels, display.begin() + (y * spec.full_width + x_begin) * channels);
  return display;
}

StampFile describe(ImageFile& file, const Part& part, const ChosenChannels& chosen) {
  const OIIO::ImageSpec& spec = part.spec;
  StampFile described;
  described.format = file.format();
  described.texel_type = spec.channelformat(chosen.channels.front()).c_str();
  described.compression = spec.get_string_attribute("compression");
  described.channels = chosen.names;
  described.unused = chosen.unused;
  described.tile_width = spec.tile_width;
  described.tile_height = spec.tile_height;
  described.mip_levels = file.count_mip_levels(part);
  described.orientation = spec.get_int_attribute("Orientation", 1);
  described.data_x = spec.x - spec.full_x;
  described.data_y = spec.y - spec.full_y;
  described.data_width = spec.width;
  described.data_height = spec.height;
  std::tie(described.wrap_u, described.wrap_v) = parse_wraps(spec.get_string_attribute("wrapmodes").c_str());
  return described;
}

StoredImage read_chosen(ImageFile& file, const StampOptions& options) {
  const std::vector<Part> parts = file.parts();
  const ChosenChannels chosen = chosen_channels(file.path(), channel_names(parts), options);
  Part part = parts[chosen.part];
  OIIO::ImageSpec& spec = part.spec;
  expect_texels(file.path(), spec, chosen.channels, file.format());
  set_window(spec, file.format());
  const auto [first, last] = std::ranges::minmax(chosen.channels);
  const int stored = last + 1 - first;
  const auto expect_size = [&](int width, int height) {
    const auto size = [](int number) { return static_cast<std::uint64_t>(std::max(number, 0)); };
    check_stamp_size(file.path(), size(width), size(height), size(stored), file.bytes());
  };
  expect_size(spec.width, spec.height);
  expect_size(spec.full_width, spec.full_height);
  if (spec.tile_width > 0) expect_size(spec.tile_width, spec.tile_height);
  StoredImage image;
  image.file = describe(file, part, chosen);
  image.image.width = spec.full_width;
  image.image.height = spec.full_height;
  image.image.channels = static_cast<int>(chosen.channels.size());
  image.image.texels = texels_of(chosen.channels, display_window(spec, stored, file.read(part, first, last)),
                                 static_cast<std::size_t>(stored), first);
  return image;
}

/// Inverts the values of an image in which 0 is white. For bytes the library has done that already.
void make_black_zero(StoredImage& image) {
  if (image.file.texel_type == "uint8") return;
  const auto channels = static_cast<std::size_t>(image.image.channels);
  for (std::size_t i = 0; i < image.image.texels.size(); i += channels)
    image.image.texels[i] = 1 - image.image.texels[i];
}

/// Rounds values to fractions of the largest number of so many bits.
void round_to_bits(unsigned bits, std::vector<float>& values) {
  const auto most = static_cast<float>((1U << bits) - 1);
  for (float& value : values) value = std::round(value * most) / most;
}

/// The values of an image of bits, in which 0 is black or, if `white_is_zero`, white.
std::vector<float> values_of_bits(const std::filesystem::path& path, bool white_is_zero) {
  std::vector<float> values = read_bits(path);
  for (float& value : values)
    if (white_is_zero) value = 1 - value;
  return values;
}

StoredImage read_tiff(const ImageFileFormat& file, const StampOptions& options) {
  const std::string path = file.path.string();
  const TiffInfo facts = read_tiff_facts(file.path, file.size);
  if (!facts.misread.empty()) throw FileError(path, "holds " + facts.misread + ", which is not read");
  if (facts.cut_off) throw FileError(path, "is cut off: texels lie beyond its end");
  if (facts.more_images) throw FileError(path, "holds several images; a stamp is one");
  if (!facts.numbers)
    throw FileError(path, "holds colours other than grey and RGB; a stamp is made of numbers");
  ImageFile opened(file);
  StoredImage image = read_chosen(opened, options);
  expect_texels_that_decode(file.path);
  if (facts.untold_bits) image.image.texels = values_of_bits(file.path, facts.white_is_zero);
  if (facts.odd_bits > 0) round_to_bits(facts.odd_bits, image.image.texels);
  if (facts.white_is_zero) make_black_zero(image);
  image.no_data = facts.no_data;
  image.no_data_texel = facts.no_data.value_or(0) / facts.greatest;
  if (facts.white_is_zero) image.no_data_texel = 1 - image.no_data_texel;
  return image;
}

StoredImage read_jpeg(const ImageFileFormat& file, const StampOptions& options) {
  const JpegInfo size = jpeg_size(read_file(file.path));
  check_stamp_size(file.path.string(), size.width, size.height, size.components, file.size);
  if (!size.has_end) throw FileError(file.path.string(), "is cut off: the end of the image is missing");
  ImageFile opened(file);
  return read_chosen(opened, options);
}

StoredImage read_exr(const ImageFileFormat& file, const StampOptions& options) {
  check_exr_header(file.path, file.size);
  ImageFile opened(file);
  return read_chosen(opened, options);
}

}  // namespace

StoredImage read_image(const ImageFileFormat& file, const StampOptions& options) {
  if (file.name == "tiff") return read_tiff(file, options);
  if (file.name == "jpeg") return read_jpeg(file, options);
  return read_exr(file, options);
}

}  // namespace burin
