#pragma once
#include <burin/stamp/files/picture.h>
#include <burin/stamp/mip_pyramid.h>

namespace burin {

/// A picture of the stamp tiled 3 x 3 according to its wrap; each tile is at most 512 pixels wide and high.
/// Values are mapped linearly, the least to sRGB 0 and the greatest to 255, over all channels shown: the
/// first three, or a single one as grey. Alpha is left out.
Picture stamp_preview(const MipPyramid& stamp);

}  // namespace burin
