#pragma once
#include <burin/stroke/stroke_choices.h>

namespace burin {

/// Options of a stroke's chart.
struct ChartOptions {
  double radius = 0;  ///< half width of the stroke, object units, > 0
  Cap cap = Cap::round;
  int order = 2;  ///< 1: Eq. 2 and 3 of the paper; 2: second order on curved strokes and surfaces
  Join join = Join::round;
  /// 0..1: how much of the surface's relief the chart follows. At 1 it follows all of it; below 1, relief
  /// wider than about a third of (1 - follow) radii, if that spans several edges; see BaseSurface.
  double follow = 1;
  bool fine = false;  ///< triangles near the stroke are small, whatever those elsewhere are
};

}  // namespace burin
