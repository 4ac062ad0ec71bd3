#pragma once
#include <burin/stamp/files/image_codec.h>

namespace burin {

/// Reads an EXR, TIFF or JPEG file as read_stored_image() does.
StoredImage read_image(const ImageFileFormat& file, const StampOptions& options);

}  // namespace burin
