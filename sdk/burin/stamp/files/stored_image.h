#pragma once
#include <burin/stamp/files/stamp_file.h>

#include <optional>

namespace burin {

/// An image as its file stores it: not turned upright, with no-data values in place. The image's wrap and
/// range are not set.
struct StoredImage {
  StampImage image;
  StampFile file;
  std::optional<double> no_data;  ///< the file's number that marks texels without data
  double no_data_texel = 0;       ///< the value of the image that it became
};

/// Reads those channels of an EXR, TIFF, PNG or JPEG file that the options choose. Throws FileError for all
/// reasons of read_stamp() but values that are not finite.
StoredImage read_stored_image(const std::filesystem::path& path, const StampOptions& options);

}  // namespace burin
