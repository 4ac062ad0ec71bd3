#pragma once
#include <burin/chart/chart_frame.h>
#include <burin/chart/chart_ground.h>
#include <burin/chart/path/front_stroke.h>

namespace burin {

/// A frame, and the arc length up to which the stroke has a say in it, object units.
struct MendedFrame {
  ChartFrame frame;
  double depends_to = 0;
};

/// The frame itself where the stroke allows what it tells; of a false one, which places the vertex nearer to
/// the stroke than a straight line is, what the stroke's own nearest point makes of the vertex. In between
/// the one goes over into the other.
MendedFrame mended_frame(const FrontStroke& stroke, const GroundVertex& vertex, const ChartFrame& frame);

}  // namespace burin
