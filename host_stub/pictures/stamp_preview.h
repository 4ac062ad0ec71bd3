#pragma once
#include <burin/stamp/files/picture.h>
#include <burin/stamp/mip_pyramid.h>

namespace burin {

/// Three by three times the stamp, as its wrap repeats it, each at most 512 pixels wide and high. The least
/// value is shown as sRGB 0 and the greatest as 255, in proportion between them, over the channels shown
/// together: the first three, or the one as grey; alpha is left out.
Picture stamp_preview(const MipPyramid& stamp);

}  // namespace burin
