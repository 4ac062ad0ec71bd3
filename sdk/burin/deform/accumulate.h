#pragma once

namespace burin {

/// The surface from which a later visit of a stroke to a vertex displaces it.
enum class Accumulate {
  from_base,     ///< the surface before the stroke; Overlap defines how the visits combine
  from_current,  ///< the surface after the stroke's earlier visits, along the normals of that surface
};

}  // namespace burin
