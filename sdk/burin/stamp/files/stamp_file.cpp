// Reads a stamp: the stored image, then no-data values, orientation, wrap, values that are not finite, and
// zero.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stamp/clean.h>
#include <burin/stamp/files/stamp_file.h>
#include <burin/stamp/files/stored_image.h>
#include <burin/stamp/orientation.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// Replaces values that equal no_data, up to the rounding of its text, by NaN.
void drop_no_data(StoredImage& stored) {
  if (!stored.no_data) return;
  const double none = stored.no_data_texel, rounding = std::abs(none) * 1e-5;
  const bool at_the_end = std::abs(none) >= double{std::numeric_limits<float>::max()};
  for (float& value : stored.image.texels) {
    const double number = double{value};
    const bool equal = std::abs(number - none) <= rounding ||
                       (at_the_end && std::abs(number) == double{std::numeric_limits<float>::max()});
    if (equal) value = std::numeric_limits<float>::quiet_NaN();
  }
}

void expect_finite(const std::string& path, const StoredImage& stored) {
  const StampImage& image = stored.image;
  const auto bad = std::find_if_not(image.texels.begin(), image.texels.end(),
                                    [](float value) { return std::isfinite(value); });
  if (bad == image.texels.end()) return;
  const auto at = bad - image.texels.begin();
  const auto texel = at / image.channels;
  const std::string why = stored.no_data && std::isnan(*bad)
                              ? fmt::format("the texel holds no data ({}); clean fills it", *stored.no_data)
                              : fmt::format("the texel is not finite ({})", *bad);
  throw FileError(path,
                  fmt::format("channel {}, x {}, y {}",
                              printable(stored.file.channels[static_cast<std::size_t>(at % image.channels)]),
                              texel % image.width, texel / image.width),
                  why);
}

/// Subtracts `zero` from all channels but alpha.
void move_zero(StampImage& image, float zero) {
  if (zero == 0) return;
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.texels.size(); ++i)
    if (i % channels < 3) image.texels[i] -= zero;
}

Wrap chosen(Wrap option, Wrap of_file) {
  if (option != Wrap::unknown) return option;
  return of_file != Wrap::unknown ? of_file : Wrap::periodic;
}

}  // namespace

StampImage read_stamp(const std::filesystem::path& path, const StampOptions& options, StampFile* file) {
  StoredImage stored = read_stored_image(path, options);
  StampImage& image = stored.image;
  drop_no_data(stored);
  apply_orientation(image, stored.file.orientation);
  image.wrap_u = chosen(options.wrap_u, stored.file.wrap_u);
  image.wrap_v = chosen(options.wrap_v, stored.file.wrap_v);
  if (options.clean) stored.file.not_finite = fill_not_finite(image);
  expect_finite(path.string(), stored);
  move_zero(image, options.zero);
  set_range(image);
  if (file) *file = std::move(stored.file);
  return std::move(image);
}

}  // namespace burin
