#pragma once
#include <burin/stroke/surface_curve.h>

#include <vector>

namespace burin {

/// Geodesic curvature of a surface curve at its points, 1 / length, positive where it bends to the left.
/// Estimated as the slope of the least-squares line through the angle by which the tangent has turned
/// against parallel transport, over the points within `window` of arc length on either side: the noise of
/// the samples averages out, and a bend shorter than the window is spread over it. Near the ends the window
/// shrinks with the distance to the end, to no less than half.
std::vector<float> geodesic_curvature(const SurfaceCurve& curve, double window);

}  // namespace burin
