#pragma once
#include <burin/stamp/stamp_image.h>

#include <string_view>

namespace burin {

/// The mean step between texels that meet when the image is repeated, as a multiple of other steps of the
/// same direction. 0 where there is no step. About 1 or less: nothing to be seen.
struct SeamStep {
  double over_interior = 0;  ///< of the mean step between all neighbours within the image
  double over_beside = 0;    ///< of the mean step at the border: from the outermost texels to the next ones
};

enum class SeamVerdict {
  tiles,          ///< no step across the border stands out
  does_not_tile,  ///< in x or y the step across the border is over twice those within and those beside it
  padded          ///< the border is of one value, to 2 % of the range: a single motif, with ground around it
};

/// How an image meets itself when it is repeated, whatever its wrap: of the channel where that is worst.
struct Seam {
  SeamStep x, y;             ///< right border to left one, lower to upper
  double border_spread = 0;  ///< greatest less least value on the border, in parts of the channel's range
  SeamVerdict verdict = SeamVerdict::tiles;
};

Seam measure_seam(const StampImage& image);

/// "tiles", "does not tile", "padded".
std::string_view verdict_name(SeamVerdict verdict);

}  // namespace burin
