// Turns images by the orientation of EXIF and TIFF.
#include <burin/stamp/orientation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace burin {
namespace {

/// The whole numbers in a block of TIFF or EXIF; numbers beyond its end are 0.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes), big_endian_(bytes.starts_with("MM")) {}

  std::uint32_t at(std::size_t place, std::size_t size) const {
    if (place > bytes_.size() || size > bytes_.size() - place) return 0;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t byte = place + (big_endian_ ? i : size - 1 - i);
      number = number << 8 | static_cast<unsigned char>(bytes_[byte]);
    }
    return number;
  }

 private:
  std::string_view bytes_;
  bool big_endian_;
};

}  // namespace

void apply_orientation(StampImage& image, int orientation) {
  if (orientation < 2 || orientation > 8) return;
  const bool exchanged = orientation >= 5;
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  StampImage upright = image;
  if (exchanged) std::swap(upright.width, upright.height);
  const auto channels = static_cast<std::size_t>(image.channels);
  std::size_t to = 0;
  for (int y = 0; y < upright.height; ++y)
    for (int x = 0; x < upright.width; ++x, to += channels) {
      int column = exchanged ? y : x, row = exchanged ? x : y;
      if (from_right) column = image.width - 1 - column;
      if (from_below) row = image.height - 1 - row;
      const std::size_t from = (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(column)) *
                               channels;
      std::copy_n(&image.texels[from], channels, &upright.texels[to]);
    }
  image = std::move(upright);
}

int exif_orientation(std::string_view exif) {
  if (exif.starts_with(std::string_view("Exif\0\0", 6))) exif.remove_prefix(6);
  const Numbers numbers(exif);
  if (numbers.at(2, 2) != 42) return 1;
  const std::size_t folder = numbers.at(4, 4);
  constexpr std::size_t entry_size = 12;
  constexpr std::uint32_t orientation_tag = 0x112;
  for (std::size_t i = 0; i < numbers.at(folder, 2); ++i) {
    const std::size_t entry = folder + 2 + i * entry_size;
    if (numbers.at(entry, 2) == orientation_tag) return static_cast<int>(numbers.at(entry + 8, 2));
  }
  return 1;
}

}  // namespace burin
