#pragma once
#include <burin/base/vector.h>
#include <burin/chart/upwind.h>
#include <burin/chart/vertex_nodes.h>
#include <burin/stroke/surface_curve.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// A vertex beside the stroke with the coordinates of its own foot point on a stroke segment.
struct Seed {
  Index vertex = no_index;
  float distance = 0;  ///< to the foot, object units
  ChartFrame frame;    ///< t at the foot, beyond the ends along the end's tangent; e1 transported from it
};

/// Finds, for every corner of the curve's points and of their one-ring, the
/// nearest foot on the segments nearby; one seed a vertex, in order of first appearance. `found` is scratch.
std::vector<Seed> find_seeds(const Surface& surface, const SurfaceCurve& curve, VertexNodes& found);

}  // namespace burin
