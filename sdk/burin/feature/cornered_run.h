#pragma once
#include <burin/feature/corners.h>
#include <burin/feature/snapped_curve.h>
#include <burin/surface/picker.h>

namespace burin {

/// A corner of a run.
struct RunCorner {
  Corner corner;
  double from = 0, to = 0;  ///< SnappedPoint::stroke_t of the part that the legs replace
};

/// Replaces the points of a run around a corner, which smoothing has rounded, by points of the corner's legs,
/// about `step` (object units) apart. The legs join the run without a step. The run stays as it is where it
/// does not reach beyond both ends of the part, or where the surface is farther from a leg than a step.
SnappedRun with_corner(const Picker& picker, const SnappedRun& run, const RunCorner& at, double step);

}  // namespace burin
