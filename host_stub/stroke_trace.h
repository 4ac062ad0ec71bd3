#pragma once
#include <burin/stroke/recording.h>
#include <burin/stroke/surface_curve.h>

namespace burin {

/// The curve of a stroke of `recording` on the surface as it is. Samples that miss the surface, or that the
/// stroke cannot reach without a gap, are left out, as Session does. `radius` in object units.
SurfaceCurve trace_stroke(const Surface& surface, const Picker& picker, const Recording& recording,
                          const RecordedStroke& stroke, double radius);

}  // namespace burin
