#pragma once
#include <burin/stamp/stamp_image.h>

#include <vector>

namespace burin {

/// One level of a pyramid.
struct MipLevel {
  StampImage image;
  /// The number of columns left and right, and of rows above and below, that the image holds outside the
  /// stamp's borders: 1 if the stamp is clamped and this is not level 0, else 0.
  int ring_u = 0, ring_v = 0;

  /// The number of texels between the borders.
  int width() const { return image.width - 2 * ring_u; }
  int height() const { return image.height - 2 * ring_v; }
};

/// A stamp and successively halved averages of it (mipmaps), for samples that cover more than one texel.
/// Needs 4/3 of the stamp's memory.
struct MipPyramid {
  /// levels[0] is the stamp; each further one has half the width and height, rounded down and 1 at least; the
  /// last has one texel between its borders.
  std::vector<MipLevel> levels;

  const StampImage& stamp() const { return levels[0].image; }
};

/// Builds the pyramid of a stamp. Every texel of a level is the mean of the level before over the texel's
/// area; texels that lie in it partly count partly. So the mean of the image is preserved, for odd sizes too,
/// and no texel reaches across the border [Guthe, Heckbert 2005, Non-power-of-two mipmap creation]. Outside a
/// clamped border values do not change with the distance, so that their means are means along the border; the
/// ring holds them. O(texels), on all threads.
MipPyramid make_mip_pyramid(StampImage stamp);

}  // namespace burin
