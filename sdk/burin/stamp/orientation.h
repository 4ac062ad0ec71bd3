#pragma once
#include <burin/stamp/stamp_image.h>

#include <string_view>

namespace burin {

/// Turns an image upright that is stored with this orientation, a number of EXIF and TIFF: 1 (upright) .. 8.
/// Any other number leaves the image unchanged. Changes width, height and texels, not the wrap.
void apply_orientation(StampImage& image, int orientation);

/// The orientation stored in an EXIF block; 1 if it has none or is damaged.
int exif_orientation(std::string_view exif);

}  // namespace burin
