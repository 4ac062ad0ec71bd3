#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace burin {

/// Options for reading a stamp.
struct StampOptions {
  Wrap wrap_u = Wrap::unknown;  ///< unknown: the mode stored in the file, else periodic
  Wrap wrap_v = Wrap::unknown;
  bool clean = false;      ///< fill values that are not finite (fill_not_finite) instead of refusing the file
  std::string layer = {};  ///< layer to choose channels from, see choose_channels()
  std::string channel = {};  ///< one name, or three or four separated by commas; empty: chosen by names
  float zero = 0;            ///< the file's value that becomes 0; does not apply to alpha

  bool operator==(const StampOptions&) const = default;
};

/// Facts about the image of a file besides its texels.
struct StampFile {
  std::string format, texel_type;       ///< "openexr", "half"
  std::string compression;              ///< empty if the file does not say
  std::vector<std::string> channels;    ///< names of the stamp's channels, in its order
  std::vector<std::string> unused;      ///< names of the file's other channels
  int tile_width = 0, tile_height = 0;  ///< 0: not tiled
  int mip_levels = 1;
  Wrap wrap_u = Wrap::unknown, wrap_v = Wrap::unknown;  ///< unknown: the file does not say
  int orientation = 1;  ///< 1 .. 8, a number of EXIF and TIFF; the stamp is turned upright
  /// The data window, in texels from the upper left corner of the image as it is stored.
  int data_x = 0, data_y = 0, data_width = 0, data_height = 0;
  std::size_t not_finite = 0;  ///< number of values that were filled
};

/// Reads a stamp from an EXR, TIFF, PNG or JPEG file, whose format its first bytes determine. Texels are
/// half, float or whole numbers of 8, 16 or 32 bits. docs/stamp_files.md has the details; in short:
/// - One, three or four channels are read, chosen by their names (choose_channels); grey with alpha is grey.
/// - Of EXR the display window is read, with 0 outside the data window, and the largest of several mip
/// levels.
/// - Whole numbers become fractions of their largest value: 255, 65535 or 4294967295, with a sign 32767 or
///   2147483647. They are linear data: no sRGB curve or gamma is undone, and alpha multiplies nothing.
/// - The image is turned upright by the orientation in the file; its position on a page is ignored.
/// - Black is 0, also in files that store white as 0. Texels marked as no data are not finite.
/// `file`: receives facts about the file; may be null.
/// Throws FileError if the file is unreadable or truncated, has other texels, channels or a format not
/// listed, several images or layers of which none is chosen, or deep texels, is too large (image_limits.h),
/// or holds a value that is not finite (the message names channel, x and y) without options.clean.
StampImage read_stamp(const std::filesystem::path& path, const StampOptions& options = {},
                      StampFile* file = nullptr);

}  // namespace burin
