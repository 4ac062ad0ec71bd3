#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/path/distance_ray.h>

namespace burin {

/// A node of the chart of one leg, or of the bend between two legs.
struct LegNode {
  Index vertex;
  Index leg;         ///< index of the leg in the order of t; bends come after all legs
  ChartFrame frame;  ///< t on the stroke
  DistanceRay ray;   ///< at the frame

  // VertexJoin sets these.
  double past = 0;         ///< how far t lies beyond the end of the leg or bend, negative before its begin
  double distance = 0;     ///< from the leg or bend, object units
  double half_width = 0;   ///< of the stroke at t, object units
  bool continued = false;  ///< the node lies beyond an end of its leg that is continued straight
  bool dropped = false;

  /// Whether the chart of the leg has the same node, whatever a join made of it.
  bool charted_as(const LegNode& other) const {
    return vertex == other.vertex && leg == other.leg && frame == other.frame && ray == other.ray;
  }
};

}  // namespace burin
