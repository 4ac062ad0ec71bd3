#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/recording.h>

#include <vector>

namespace burin {

/// How samples become curves.
struct TraceOptions {
  double radius = 0;  ///< object units
  Closure closure = Closure::open;
  StrokeWidth width;
};

/// The curves of a stroke of `recording` on the ground as it is: one for each piece between the places
/// where the pen leaves the surface or jumps over a gap, as replay() draws them.
std::vector<SurfaceCurve> trace_stroke(const CurveGround& ground, const Recording& recording,
                                       const RecordedStroke& stroke, const TraceOptions& options);

}  // namespace burin
