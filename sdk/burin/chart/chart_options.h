#pragma once
#include <burin/chart/stroke_shape.h>

namespace burin {

/// What a stroke is charted with.
struct ChartOptions {
  double radius = 0;  ///< half width of the stroke, object units, > 0
  Cap cap = Cap::round;
  int order = 2;  ///< 1: Eq. 2 and 3 of the paper; 2: second order on curved strokes and surfaces
  Join join = Join::round;
  /// 0..1: how much of the surface's relief the chart feels. 1: all of it. Less: what is wider than about a
  /// third of (1 - follow) radii, where the surface has several edges in that; see BaseSurface.
  double follow = 1;
};

}  // namespace burin
