#pragma once

namespace burin {

/// What a stroke starts from where it comes to a place again.
enum class Accumulate {
  from_base,     ///< the surface as it was when the stroke began; Overlap says what the visits make together
  from_current,  ///< what its earlier visits have left: later ones go on from there, along its normals
};

}  // namespace burin
