#pragma once
#include <burin/stamp/files/stamp_file.h>

#include <optional>

namespace burin {

/// An image as its file stores it: not turned upright, its values as they are. The image's wrap and range are
/// not set.
struct StoredImage {
  StampImage image;
  StampFile file;
  std::optional<double> no_data;  ///< the value of texels that hold nothing
};

/// The image of an EXR, TIFF, PNG or JPEG file of which the options choose the channels. Throws as
/// read_stamp.
StoredImage read_stored_image(const std::filesystem::path& path, const StampOptions& options);

}  // namespace burin
