#pragma once
#include <burin/deform/stroke_nodes.h>

#include <vector>

namespace burin {

/// What an event did to the nodes of a growing stroke.
struct StrokeChanges {
  std::vector<Index> stale;  ///< nodes of the chart now whose outputs must be computed, ascending
  std::vector<Index> left;   ///< vertices of the chart before that are not in the chart now, ascending
};

/// Nodes are stale that are new, whose inputs differ in any bit, or whose t is at least `end_zone`: there
/// the brush may look at the stroke's length.
StrokeChanges find_changes(const StrokeNodes& before, const StrokeNodes& now, double end_zone);

/// Nodes whose t is at least `end_zone`, ascending.
std::vector<Index> nodes_from(const Chart& chart, double end_zone);

}  // namespace burin
