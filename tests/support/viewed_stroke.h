#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <optional>
#include <random>
#include <vector>

namespace burin::test {

/// The curve of a pen that draws on the part of a surface that is visible from above a random vertex. Samples
/// are given in the plane, in units of the radius, and meet the surface along the vertex's normal, from three
/// radii above. The curve ends where the pen leaves the visible part or jumps over a silhouette. Returns
/// nothing if that happens in its first half, or if the curve itself leaves the surface, for example over a
/// fold that is narrower than the pen's steps.
std::optional<SurfaceCurve> viewed_stroke(const Surface& surface, const Picker& picker,
                                          const std::vector<Vec2d>& in_radii, double radius,
                                          std::mt19937& random);

}  // namespace burin::test
