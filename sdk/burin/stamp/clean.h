#pragma once
#include <burin/stamp/stamp_image.h>

#include <cstddef>

namespace burin {

/// Gives every value that is not finite the mean of the finite ones among the texel's eight neighbours in
/// the same channel, neighbours across the border by the image's wrap among them; then those next to these,
/// and so on. A channel without a finite value becomes 0. Returns the number of values filled. The image's
/// range is not set anew.
std::size_t fill_not_finite(StampImage& image);

}  // namespace burin
