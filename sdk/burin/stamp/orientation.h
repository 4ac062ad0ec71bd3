#pragma once
#include <burin/stamp/stamp_image.h>

#include <string_view>

namespace burin {

/// How an image is stored that is to be seen upright: the numbers of EXIF and TIFF, 1 (upright) .. 8.
/// Any other number leaves the image as it is. Turns width, height and texels; not the wrap.
void set_upright(StampImage& image, int orientation);

/// The orientation that a block of EXIF tells; 1 where it tells none or is damaged.
int exif_orientation(std::string_view exif);

}  // namespace burin
