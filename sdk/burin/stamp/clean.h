#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstddef>

namespace burin {

/// Replaces every value that is not finite by the mean of the finite values among the eight neighbours of the
/// texel in the same channel, across the border according to the image's wrap. Texels without finite
/// neighbours follow in further rounds. A channel without any finite value becomes 0. Returns the number of
/// values replaced. Does not update the image's range. O(texels).
std::size_t fill_not_finite(StampImage& image);

}  // namespace burin
