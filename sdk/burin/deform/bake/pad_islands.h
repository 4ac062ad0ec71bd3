#pragma once
#include <burin/base/float_image.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Continues an image outward from the texels that have a value, by `texels` rounds, so that a filter at the
/// border of an island meets nothing from outside. A texel beside known ones (of 8) gets, in the first round,
/// the mean of what lines through two of them lead to: that is the round bilinear lookups on the border see.
/// Where there are no two in line, and in later rounds, it gets the mean of the known neighbours, which does
/// not run away. `known`: [texel], 1 where the image has a value, else 0 and the image is 0; those that get
/// one become 1.
void pad_islands(FloatImage& image, std::vector<std::uint8_t>& known, int texels);

}  // namespace burin
