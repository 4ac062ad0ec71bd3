#pragma once
#include <burin/stamp/stamp_image.h>

#include <span>
#include <vector>

namespace burin {

/// A stamp and ever smaller averages of it, for samples that cover more than one texel.
struct MipPyramid {
  /// levels[0] is the stamp; each further one has half the width and height, rounded down and 1 at least; the
  /// last has one texel.
  std::vector<StampImage> levels;
};

/// Every texel of a level is the mean of the level before over the texel's area, where texels that lie in it
/// in part count in part: so means stay what they are, of odd sizes too, and no texel reaches across the
/// border [Guthe, Heckbert 2005, Non-power-of-two mipmap creation].
MipPyramid make_mip_pyramid(StampImage stamp);

/// Where to sample, and how widely. All arrays of one length.
struct MipPlaces {
  std::span<const float> u, v;       ///< as for sample_bilinear
  std::span<const float> footprint;  ///< width of the sampled area in texels of the stamp
};

/// Writes trilinear samples of a channel: bilinear in the levels whose texels are the next smaller and larger
/// than the footprint, in proportion to it between them. Bit for bit sample_bilinear of level k where the
/// footprint is 2^k, of the stamp below 1, of the last level beyond. NaN where u or v is not finite or the
/// footprint NaN. Any thread.
void sample_mip(const MipPyramid& pyramid, int channel, const MipPlaces& places, std::span<float> values);

}  // namespace burin
