#pragma once
#include <burin/base/float_image.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Extends an image outward from its known texels, by `texels` rounds, so that filters at the border of an
/// island do not mix in texels from outside. In the first round, which bilinear lookups at the border read,
/// an unknown texel beside known ones (of 8 neighbours) gets the mean of linear extrapolations along lines of
/// two known texels. Without two texels in a line, and in later rounds, it gets the mean of its known
/// neighbours, which is stable. known[texel] is 1 if the texel has a value; otherwise it is 0 and the texel
/// must be 0. It becomes 1 for padded texels.
void pad_islands(FloatImage& image, std::vector<std::uint8_t>& known, int texels);

}  // namespace burin
