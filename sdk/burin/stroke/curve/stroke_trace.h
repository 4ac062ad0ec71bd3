#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/stroke/recording.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// How curves are made of samples.
struct TraceOptions {
  double radius = 0;  ///< object units
  Closure closure = Closure::open;
  StrokeWidth width;
};

/// What stroke `number` (from 0) of the file at `path` is drawn with, but for the brush: its own settings, or
/// those `given` instead. Throws FileError if neither has a radius.
ReplaySettings settings_to_trace(const std::string& path, const RecordedStroke& stroke, std::size_t number,
                                 const GivenSettings& given);

/// The options to trace stroke `number` (from 0) of a file with, as replay() does.
TraceOptions trace_options(const ReplaySettings& settings, const PenFields& fields, std::size_t number);

/// The curves of a stroke of `recording` on the current ground, as replay() draws them. A new curve starts
/// where the pen leaves the surface or jumps over a gap.
std::vector<SurfaceCurve> trace_stroke(const CurveGround& ground, const Recording& recording,
                                       const RecordedStroke& stroke, const TraceOptions& options);

}  // namespace burin
