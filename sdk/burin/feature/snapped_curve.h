#pragma once
#include <burin/stroke/curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// A point that a stroke goes through instead of one of its own.
struct SnappedPoint {
  double stroke_t = 0;  ///< arc length on the stroke of the point that it replaces, object units
  SurfacePoint at;
};

/// Successive points, ascending in stroke_t; those on closed strokes may go beyond the stroke's length.
using SnappedRun = std::vector<SnappedPoint>;

/// A stroke with parts that were moved.
struct SnappedCurve {
  SurfaceCurve curve;
  std::vector<double> stroke_t;  ///< [point of the curve] arc length of the corresponding point of the stroke
};

/// Replaces parts of a stroke by runs of points, which do not overlap. Beside each run the stroke's own
/// points are moved towards it, over at most twice the distance that its end was moved; all others stay as
/// they are to the bit. New points have the pen of the stroke at their stroke_t. If `whole`, the only run
/// takes the place of a whole closed stroke. Points nearer to the one before than `least_step` (object units)
/// are left out.
SnappedCurve snapped_curve(const Surface& surface, const Picker& picker, const SurfaceCurve& stroke,
                           const std::vector<SnappedRun>& runs, bool whole, double least_step);

/// The position of a stroke at an arc length, clamped to an open stroke and periodic on a closed one.
Vec3d stroke_position(const SurfaceCurve& stroke, double t);

}  // namespace burin
