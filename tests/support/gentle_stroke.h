#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <random>

namespace burin::test {

/// The mean length of the triangles' edges, object units.
double mean_edge(const Surface& surface);

/// A stroke from a random point on the outside, in a random direction that swings left and right with turning
/// radii of at least 2 stroke radii. It is about `length` long (object units); shorter, or empty, if it
/// leaves the surface or would jump.
SurfaceCurve gentle_stroke(const Surface& surface, const Picker& picker, double radius, double length,
                           std::mt19937& random);

}  // namespace burin::test
