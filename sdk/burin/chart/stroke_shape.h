#pragma once

namespace burin {

/// How a stroke ends.
enum class Cap {
  butt,   ///< the chart ends where t leaves [0, length]
  round,  ///< half a geodesic disc of the stroke's radius beyond each end
};

/// What becomes of the coordinates where the stroke bends sharper than its radius.
enum class Join {
  round,    ///< as the distances have it: around the outside of the bend t hardly moves, inside it jumps
  smooth,   ///< t is spread evenly along the lines of constant d on the way through the bend, inside and out
  miter,    ///< the straight coordinates of the legs go on to where they meet; up to 120 degrees, else round
  overlap,  ///< each leg ends in the bend as strokes end, and both have sheets of their own there; so has the
            ///< bend if it is no corner
};

}  // namespace burin
