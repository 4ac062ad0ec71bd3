#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace burin {

struct StampOptions {
  Wrap wrap_u = Wrap::unknown;  ///< unknown: as the file says, periodic where it says nothing
  Wrap wrap_v = Wrap::unknown;
  bool clean = false;  ///< fill values that are not finite (fill_not_finite) instead of refusing the file

  bool operator==(const StampOptions&) const = default;
};

/// What a file says of its image besides the texels.
struct StampFile {
  std::string format, texel_type;  ///< "openexr", "half"
  std::string compression;         ///< empty where the file does not tell
  std::vector<std::string> channels;
  int tile_width = 0, tile_height = 0;  ///< 0: not tiled
  int mip_levels = 1;
  Wrap wrap_u = Wrap::unknown, wrap_v = Wrap::unknown;  ///< unknown: the file does not tell
  /// Data window, in texels from the stamp's upper left corner.
  int data_x = 0, data_y = 0, data_width = 0, data_height = 0;
  std::size_t not_finite = 0;  ///< values that were filled
};

/// Reads an image of 1, 3 or 4 channels of half, float, uint16 or uint8 texels from an EXR, TIFF, PNG or JPEG
/// file: the display window, 0 where the data window leaves it out; the largest of a file's mip levels. Whole
/// numbers are read as fractions of their largest, 65535 or 255, and as linear: a stamp is data, so no sRGB
/// curve is undone and colour is not multiplied by alpha.
/// Throws FileError: not readable, truncated, other texels, channels or formats, several parts, deep texels,
/// more than 2^28 values, a value that is not finite (named by channel, x, y) unless options.clean.
StampImage read_stamp(const std::filesystem::path& path, const StampOptions& options = {},
                      StampFile* file = nullptr);

}  // namespace burin
