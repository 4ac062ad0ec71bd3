#pragma once
#include <burin/chart/stroke_samples.h>
#include <burin/chart/vertex_nodes.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// The nodes of a stroke's chart. A vertex has one for each visit of the stroke: a run of samples whose discs
/// all hold the vertex, as long as it goes [Schmidt 2013, section 4.1]. A node is known by its vertex and
/// by where its run begins, which neither the order of discovery nor the growth of the stroke changes.
class ChartNodes {
 public:
  explicit ChartNodes(const Surface& surface) : surface_(&surface), first_(surface.vertex_count()) {}

  void clear();

  /// Follows a change of the samples from the first one that differs. Nodes whose runs begin there or later
  /// become vacant: they hold nothing until at() uses them again.
  void update(const StrokeSamples& samples, Index first_changed);

  Index size() const { return static_cast<Index>(nodes_.size()); }
  Index vertex(Index node) const { return nodes_[node].vertex; }

  /// The first sample of the node's run.
  Index begin(Index node) const { return nodes_[node].begin; }

  /// The nodes of a vertex, one after the other, in no particular order; no_index at the end.
  Index first(Index vertex) const;
  Index next(Index node) const { return nodes_[node].next; }

  bool vacant(Index node) const { return !wraps_ && nodes_[node].begin > nodes_[node].end; }

  /// Whether the node's run holds the sample.
  bool holds(Index node, Index sample) const {
    const auto& [vertex, begin, end, next] = nodes_[node];
    return begin <= end ? begin <= sample && sample <= end : wraps_ && (begin <= sample || sample <= end);
  }

  /// The node of the vertex whose run holds the sample, made if need be. no_index when the sample's disc
  /// does not hold the vertex.
  Index at(const StrokeSamples& samples, Index vertex, Index sample);

 private:
  struct Node {
    Index vertex;
    Index begin, end;  ///< the run's samples, both included; begin > end: it wraps around, or is vacant
    Index next;        ///< of the same vertex
  };
  struct Run {
    Index begin, end;
  };
  Run run_around(const StrokeSamples& samples, Index vertex, Index sample) const;
  bool in_disc(const StrokeSamples& samples, Index vertex, Index sample) const;

  const Surface* surface_;
  VertexNodes first_;              ///< vertices that have nodes
  std::vector<Index> first_node_;  ///< [entry of first_]
  std::vector<Node> nodes_;
  bool wraps_ = false;
};

}  // namespace burin
