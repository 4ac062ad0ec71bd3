#pragma once

namespace burin {

/// How a stroke ends.
enum class Cap {
  butt,   ///< the chart ends where t leaves [0, length]
  round,  ///< half a geodesic disc of the stroke's radius beyond each end
};

/// How coordinates are defined where the stroke bends sharper than its radius.
enum class Join {
  round,    ///< by geodesic distance alone: around the outside of the bend t hardly changes, inside it jumps
  smooth,   ///< t is spread evenly along the lines of constant d through the bend, inside and outside
  miter,    ///< the legs' straight coordinates continue until they meet; below 120 degrees, else round
  overlap,  ///< each leg ends at the bend with the stroke's cap, and the legs have separate sheets there; a
            ///< bend that is longer than half a radius is a leg too
};

}  // namespace burin
