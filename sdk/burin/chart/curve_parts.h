#pragma once
#include <burin/stroke/surface_curve.h>

namespace burin {

/// The part of a curve between two arc lengths, begin < end, as an open curve of its own, whose t counts from
/// its begin. On a closed curve `end` may be beyond the length: the part goes on across the seam.
SurfaceCurve part_of(const SurfaceCurve& curve, double begin, double end);

}  // namespace burin
