#pragma once
#include <burin/stroke/curve/surface_curve.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <random>

namespace burin::test {

/// Mean length of an edge of the triangles, object units.
double mean_edge(const Surface& surface);

/// A stroke from a random place, seen from outside, in a random direction that swings to and fro with turning
/// radii of 2 radii and more, about `length` long (object units); shorter, or empty, where it leaves the
/// surface or would jump.
SurfaceCurve gentle_stroke(const Surface& surface, const Picker& picker, double radius, double length,
                           std::mt19937& random);

}  // namespace burin::test
