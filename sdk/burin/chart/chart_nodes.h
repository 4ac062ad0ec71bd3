#pragma once
#include <burin/chart/chart_ground.h>
#include <burin/chart/front_node.h>
#include <burin/chart/stroke_samples.h>

#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// A range of vertices.
struct VertexRange {
  Index begin = 0, end = no_index;
  bool holds(Index vertex) const { return vertex - begin < end - begin; }
};

/// The nodes of a stroke's front. A vertex has one for each visit of the stroke: a run of samples whose discs
/// all hold the vertex, as long as it goes [Schmidt 2013, section 4.1]. Runs are a function of samples and
/// vertex; how much of a run is known grows with the samples that somebody asks for.
///
/// The first nodes of consecutive vertices, which are neighbours for the most part, lie side by side in
/// memory, in blocks that are made when the front first comes by. Nodes that no visit has needed are vacant.
class ChartNodes {
 public:
  static constexpr Index block_size = 16;

  /// The blocks that this many vertices take up.
  static Index blocks_of(Index vertices) { return (vertices + block_size - 1) / block_size; }

  /// `blocks`: scratch memory for blocks_of() all vertices; zeroes, or as another use left it. All must
  /// outlive the object.
  ChartNodes(const ChartGround& ground, const StrokeSamples& samples, std::span<Index> blocks)
      : ground_(&ground), samples_(&samples), block_of_(blocks) {}

  /// Forgets everything. Of `blocks`, those of `own` are written only, which begins with a block and ends
  /// with one, or with the last vertex.
  void restart(VertexRange own);

  /// Follows a change of the samples from this one on. Of nodes whose runs are known from there on only,
  /// nothing is known any more: they become vacant as soon as somebody asks.
  void samples_changed(Index first_changed);

  Index size() const { return static_cast<Index>(nodes_.size()); }
  FrontNode& operator[](Index node) { return nodes_[node]; }
  const FrontNode& operator[](Index node) const { return nodes_[node]; }

  /// The nodes of a vertex, linked by `next`, in no particular order; no_index: none.
  Index first(Index vertex) const {
    if (!own_.holds(vertex)) return first_foreign(vertex);
    const Index node = block_of_[vertex / block_size] + vertex % block_size;
    return node < size() && nodes_[node].vertex() == vertex ? node : no_index;
  }

  /// A node of a vertex that is not own, without a run. Moves all in memory.
  Index add_foreign(Index vertex) {
    const Index node = add_loose(vertex);
    put(nodes_[node], (*ground_)[vertex]);
    return node;
  }

  /// Whether the node's run holds the sample.
  bool holds(Index node, Index sample) {
    return known_to_hold(nodes_[node], sample) || found_to_hold(nodes_[node], sample);
  }

  /// The node of the vertex whose run holds the sample, made if need be; adding nodes moves all in memory.
  /// no_index when the sample's disc does not hold the vertex.
  Index at(Index vertex, Index sample) {
    const Index head = first(vertex);
    if (head != no_index && known_to_hold(nodes_[head], sample)) return head;
    return find_or_add(vertex, sample, head);
  }

 private:
  bool known_to_hold(const FrontNode& node, Index sample) const {
    return node.run_epoch == epoch_ && steps_from(node.run_begin, sample) < node.run_length;
  }
  bool found_to_hold(FrontNode& node, Index sample) const;
  Index find_or_add(Index vertex, Index sample, Index head);
  /// How many samples after `from` the sample comes; on an open stroke more than there are when it comes
  /// before.
  Index steps_from(Index from, Index sample) const {
    return sample >= from || !closed_ ? sample - from : sample + count_ - from;
  }
  Index first_foreign(Index vertex) const;
  Index add(Index vertex, Index sample, Index head);
  Index add_block(Index vertex);
  Index add_loose(Index vertex);
  void set_vertex(FrontNode& node, Index vertex) const;
  static void put(FrontNode& node, const GroundPlace& place);
  void begin_run(FrontNode& node, const GroundPlace& place, Index sample) const;
  void forget_changed(FrontNode& node) const;
  bool extends_to(FrontNode& node, Index sample) const;
  bool extends_forward(FrontNode& node, Index sample) const;
  bool extends_backward(FrontNode& node, Index sample) const;
  bool in_disc(const FrontNode& node, Index sample) const {
    return samples_->disc_holds(sample, node.position, node.normal);
  }

  const ChartGround* ground_;
  const StrokeSamples* samples_;
  VertexRange own_;
  std::span<Index> block_of_;  ///< [vertex / block_size] its first node, perhaps of another use
  std::unordered_map<Index, Index> foreign_;  ///< first nodes of other vertices
  std::vector<FrontNode> nodes_;
  Index count_ = 0;  ///< of the samples
  bool closed_ = false;
  Index epoch_ = 0;                   ///< counts the changes of the samples
  std::vector<Index> least_changed_;  ///< [epoch] the first sample that has changed after it
};

}  // namespace burin
