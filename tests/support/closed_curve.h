#pragma once
#include <burin/stroke/curve/surface_curve.h>

namespace burin::test {

/// Closes a curve of several points whose last point is at the position of the first.
inline void close(SurfaceCurve& curve) {
  const double length = curve.length();
  curve.points.pop_back();
  curve.closed = true;
  curve.closing_length = length - curve.points.back().t;
}

}  // namespace burin::test
