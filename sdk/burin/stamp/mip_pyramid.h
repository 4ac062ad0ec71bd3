#pragma once
#include <burin/stamp/stamp_image.h>

#include <vector>

namespace burin {

/// An image of a pyramid.
struct MipLevel {
  StampImage image;
  /// Columns left and right, and rows above and below, that the image holds beyond the stamp's borders: 1
  /// where the stamp is clamped and this is not the stamp itself, else 0.
  int ring_u = 0, ring_v = 0;

  /// Texels from border to border.
  int width() const { return image.width - 2 * ring_u; }
  int height() const { return image.height - 2 * ring_v; }
};

/// A stamp and ever smaller averages of it, for samples that cover more than one texel. Takes 4/3 of the
/// stamp's memory.
struct MipPyramid {
  /// levels[0] is the stamp; each further one has half the width and height, rounded down and 1 at least; the
  /// last has one texel between its borders.
  std::vector<MipLevel> levels;

  const StampImage& stamp() const { return levels[0].image; }
};

/// Every texel of a level is the mean of the level before over the texel's area, where texels that lie in it
/// in part count in part: so means stay what they are, of odd sizes too, and no texel reaches across the
/// border [Guthe, Heckbert 2005, Non-power-of-two mipmap creation]. What lies beyond a clamped border is the
/// same at any distance, so that means of it are means along the border: the ring.
MipPyramid make_mip_pyramid(StampImage stamp);

}  // namespace burin
