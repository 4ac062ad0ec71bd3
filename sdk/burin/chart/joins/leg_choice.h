#pragma once
#include <burin/chart/joins/leg_node.h>
#include <burin/chart/joins/stroke_legs.h>

#include <span>

namespace burin {

/// Chooses between the nodes that the two legs of a corner have at one vertex; drops the others. Around the
/// corner the vertex keeps the node of the leg on whose side of the bisector it lies, which reaches less far
/// beyond the corner. Elsewhere it keeps the node that is nearer to its leg, so that it does not lose a node
/// within the stroke to one outside. Where the legs are not continued, since they nearly coincide, it keeps
/// both nodes. Nodes farther from the corner along their legs than corner_nearness radii are kept. `radius`
/// is that of the stroke, object units; `ends` is indexed by leg. O(n^2) for the n nodes of the vertex.
void choose_at_corners(std::span<LegNode> of_vertex, std::span<const LegEnds> ends, double radius);

}  // namespace burin
