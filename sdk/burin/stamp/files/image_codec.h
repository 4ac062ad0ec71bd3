#pragma once
#include <burin/base/float_image.h>
#include <burin/stamp/files/stored_image.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace burin {

/// A file that begins like an image.
struct ImageFileFormat {
  std::filesystem::path path;
  std::string_view name;    ///< "openexr", "tiff", "png" or "jpeg"
  std::uintmax_t size = 0;  ///< bytes
};

/// The image files that are read and written with OpenImageIO. Any thread may call the functions, several at
/// once.
struct ImageCodec {
  /// Reads an EXR, TIFF or JPEG file as read_stored_image() does.
  StoredImage (*read)(const ImageFileFormat& file, const StampOptions& options);
  /// Writes an EXR file as write_exr() does.
  void (*write_exr)(const std::filesystem::path& path, const FloatImage& image);
};

/// A program links one of two definitions: that in `image_codec`, which is linked to OpenImageIO, or that in
/// `image_module`, which loads the library at the first call. Throws FileError if it cannot be loaded.
const ImageCodec& image_codec();

}  // namespace burin
