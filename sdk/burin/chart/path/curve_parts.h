#pragma once
#include <burin/stroke/curve/surface_curve.h>

namespace burin {

/// The segment that holds the arc length t, or the first or last segment beyond the ends. O(log n).
std::size_t segment_at(const SurfaceCurve& curve, double t);

/// The first segment of the unbroken sequence up to `segment` whose members end at t or later; `segment`
/// itself when its predecessor ends before t.
std::size_t first_ending_from(const SurfaceCurve& curve, std::size_t segment, double t);

/// The point at an arc length, interpolated between the curve's points. On a closed curve t counts modulo the
/// length.
CurvePoint point_at(const SurfaceCurve& curve, double t);

/// Whether the stroke's width is 1 everywhere.
bool has_uniform_width(const SurfaceCurve& curve);

/// The part of a curve between two arc lengths, begin < end, as an open curve whose t starts at 0. On a
/// closed curve `end` may lie beyond the length: the part continues across the seam.
SurfaceCurve part_of(const SurfaceCurve& curve, double begin, double end);

/// Makes `part`, which part_of() made of an open curve with the same begin, that of the curve as it is now.
/// The curve is as it was below the arc length `unchanged_t`, greater than `begin`. Returns the number of
/// first points of the part that were kept. Costs O(log n) and what changes.
std::size_t update_part(SurfaceCurve& part, const SurfaceCurve& curve, double begin, double end,
                        double unchanged_t);

}  // namespace burin
