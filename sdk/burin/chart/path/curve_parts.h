#pragma once
#include <burin/stroke/curve/surface_curve.h>

namespace burin {

/// The segment that holds the arc length t; beyond the ends the first or last.
std::size_t segment_at(const SurfaceCurve& curve, double t);

/// Going back from a segment, the first one of those in a row that end at t or later, or the segment itself.
std::size_t first_ending_from(const SurfaceCurve& curve, std::size_t segment, double t);

/// The point at an arc length, between the points around it. On a closed curve arc lengths go around.
CurvePoint point_at(const SurfaceCurve& curve, double t);

/// The part of a curve between two arc lengths, begin < end, as an open curve of its own, whose t counts from
/// its begin. On a closed curve `end` may be beyond the length: the part goes on across the seam.
SurfaceCurve part_of(const SurfaceCurve& curve, double begin, double end);

}  // namespace burin
