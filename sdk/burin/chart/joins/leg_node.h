#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/path/distance_ray.h>

namespace burin {

/// A part of a stroke that is charted by itself: leg i has the number 2 i, the bend at cut i the number 2 i
/// + 1.
inline constexpr Index part_of_leg(Index leg) { return 2 * leg; }
inline constexpr Index part_of_cut(Index cut) { return 2 * cut + 1; }

/// A node of the chart of one part.
struct LegNode {
  Index part = no_index;
  Index slot = no_index;  ///< of the node in the front that charted the part
  ChartFrame frame;       ///< t on the stroke
  DistanceRay ray;        ///< at the frame

  // VertexJoin sets these.
  double past = 0;         ///< how far t lies beyond the end of the leg or bend, negative before its begin
  double distance = 0;     ///< from the leg or bend, object units
  double half_width = 0;   ///< of the stroke at t, object units
  bool continued = false;  ///< the node lies beyond an end of its leg that is continued straight
  bool dropped = false;

  bool is_of_bend() const { return part % 2 == 1; }
  Index leg() const { return part / 2; }  ///< of a node that is not of a bend
  Index cut() const { return part / 2; }  ///< of a node of a bend
};

}  // namespace burin
