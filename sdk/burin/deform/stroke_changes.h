#pragma once
#include <burin/deform/stroke_nodes.h>

#include <cstdint>
#include <vector>

namespace burin {

/// What an event did to the nodes of a growing stroke.
struct StrokeChanges {
  std::vector<Index> before;   ///< [node now] the same node before; no_index where it is stale
  std::vector<Index> stale;    ///< nodes now whose outputs must be computed, ascending
  std::vector<Index> altered;  ///< first node of each vertex with stale nodes or fewer than before, ascending
  std::vector<Index> left;     ///< vertices of the chart before that are not in the chart now, ascending
};

/// Nodes are stale that are new, whose inputs differ in any bit, or whose t is at least `end_zone`: there
/// the brush may look at the stroke's length. The nodes of a vertex are told apart by t, since sheets are
/// counted anew when one appears before them. `inputs`: that the brush reads.
StrokeChanges find_changes(const StrokeNodes& before, const StrokeNodes& now, double end_zone,
                           std::uint64_t inputs);

}  // namespace burin
