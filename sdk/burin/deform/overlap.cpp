// Chooses the overlap rule of a stroke from what its brush declares.
#include <burin/abi/plugin.h>
#include <burin/deform/overlap.h>

namespace burin {

Overlap over_passes(Overlap chosen, std::uint32_t passes) {
  return chosen == Overlap::add && passes > 1 ? Overlap::strongest : chosen;
}

Overlap overlap_of(const burin_brush_descriptor& brush) {
  if (!BURIN_HAS(&brush, burin_brush_descriptor, overlap)) return Overlap::strongest;
  switch (brush.overlap) {
    case BURIN_OVERLAP_LATEST:
      return Overlap::latest;
    case BURIN_OVERLAP_MAX:
      return Overlap::max;
    case BURIN_OVERLAP_MIN:
      return Overlap::min;
    case BURIN_OVERLAP_ADD:
      return Overlap::add;
    case BURIN_OVERLAP_AVERAGE:
      return Overlap::average;
    default:
      return Overlap::strongest;
  }
}

}  // namespace burin
