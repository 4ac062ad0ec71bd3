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
  bool clean = false;      ///< fill values that are not finite (fill_not_finite) instead of refusing the file
  std::string layer = {};  ///< whose channels count, as choose_channels takes it
  std::string channel = {};  ///< one, or three or four between commas, instead of those that names tell
  float zero = 0;  ///< the file's value that is to be 0: half for whole numbers with a sign; not of alpha

  bool operator==(const StampOptions&) const = default;
};

/// What a file says of its image besides the texels.
struct StampFile {
  std::string format, texel_type;       ///< "openexr", "half"
  std::string compression;              ///< empty where the file does not tell
  std::vector<std::string> channels;    ///< those of the stamp, in its order
  std::vector<std::string> unused;      ///< the file's others
  int tile_width = 0, tile_height = 0;  ///< 0: not tiled
  int mip_levels = 1;
  Wrap wrap_u = Wrap::unknown, wrap_v = Wrap::unknown;  ///< unknown: the file does not tell
  int orientation = 1;  ///< 1 .. 8, as EXIF and TIFF tell; the stamp is turned upright
  /// Data window, in texels from the upper left corner of the image as it is stored.
  int data_x = 0, data_y = 0, data_width = 0, data_height = 0;
  std::size_t not_finite = 0;  ///< values that were filled
};

/// Reads an image of half, float or whole texels, of 8, 16 or 32 bits, from an EXR, TIFF, PNG or JPEG file,
/// told by its first bytes. docs/stamp_files.md has all that is read, in short:
/// - of the channels one, three or four, chosen by their names (choose_channels); grey with alpha is grey;
/// - of EXR the display window, 0 where the data window leaves it out, and the largest of several mip levels;
/// - whole numbers as fractions of their largest, 255, 65535 or 4294967295, with a sign 32767 or 2147483647,
///   and as linear: a stamp is data, so no sRGB curve or gamma is undone and colour is not multiplied by
///   alpha;
/// - upright, where the file tells how it is turned; a place on a page is left out;
/// - black as 0, also where the file has white as 0; what it marks as no data as not finite.
/// Throws FileError: not readable, truncated, other texels, channels or formats, several images or layers and
/// none chosen, deep texels, too large (image_limits.h), a value that is not finite (named by channel, x, y)
/// unless options.clean.
StampImage read_stamp(const std::filesystem::path& path, const StampOptions& options = {},
                      StampFile* file = nullptr);

}  // namespace burin
