#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/recording.h>

#include <vector>

namespace burin {

/// How curves are made of samples.
struct TraceOptions {
  double radius = 0;  ///< object units
  Closure closure = Closure::open;
  StrokeWidth width;
};

/// The curves of a stroke of `recording` on the current ground, as replay() draws them. A new curve starts
/// where the pen leaves the surface or jumps over a gap.
std::vector<SurfaceCurve> trace_stroke(const CurveGround& ground, const Recording& recording,
                                       const RecordedStroke& stroke, const TraceOptions& options);

}  // namespace burin
