#pragma once
#include <burin/stamp/stamp_image.h>

#include <string_view>

namespace burin {

/// The mean step between the texels that meet when the image is repeated, relative to other steps in the same
/// direction. 0 if there is no step. With values of about 1 or less no seam is visible.
struct SeamStep {
  double over_interior = 0;  ///< relative to the mean step between all neighbours within the image
  double over_beside = 0;    ///< relative to the mean step from the outermost texels to the next ones
};
/// Whether an image can be tiled.

/// Whether an image can be tiled.
enum class SeamVerdict {
  tiles,          ///< no step across the border stands out
  does_not_tile,  ///< in x or y the step across the border is over twice both other mean steps
  padded          ///< the border has one value, to 2 % of the range: a single motif on a background
};

/// The seam of an image that is repeated, whatever its wrap. Each member is that of the worst channel.
struct Seam {
  SeamStep x, y;             ///< from the right border to the left one, from the lower to the upper
  double border_spread = 0;  ///< greatest minus least value on the border, over the channel's range
  SeamVerdict verdict = SeamVerdict::tiles;
};
/// Measures the seams of an image in O(texels).

/// Measures the seams of an image in O(texels).
Seam measure_seam(const StampImage& image);

/// The name of a verdict: "tiles", "does not tile" or "padded".
std::string_view verdict_name(SeamVerdict verdict);

}  // namespace burin
