#pragma once
#include <burin/base/vector.h>
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <optional>
#include <random>
#include <vector>

namespace burin::test {

/// The curve of a pen that draws on what is seen of a surface from above a random vertex: its samples are
/// given in the plane, in units of the radius, and meet the surface along the vertex's normal, from three
/// radii above it. The curve ends where the pen leaves what is seen or jumps over a silhouette. Nothing where
/// it does so in its first half, or where the curve itself leaves the surface, as over a fold that is
/// narrower than the pen's steps.
std::optional<SurfaceCurve> viewed_stroke(const Surface& surface, const Picker& picker,
                                          const std::vector<Vec2d>& in_radii, double radius,
                                          std::mt19937& random);

}  // namespace burin::test
