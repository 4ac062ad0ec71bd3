#pragma once
#include <burin/chart/chart_ground.h>
#include <burin/chart/front/front_node.h>
#include <burin/chart/path/visit.h>

#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// A range of vertices.
struct VertexRange {
  Index begin = 0, end = no_index;
  bool holds(Index vertex) const { return vertex - begin < end - begin; }
};

/// The nodes of a stroke's front. A vertex has one for each Visit of the stroke that somebody has asked for.
/// As long as nobody asks for more than samples in a row between which the stroke cannot turn, a visit is
/// known for these only.
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

  /// Follows a change of the samples from this one on. Nodes whose visits begin there become vacant as soon
  /// as somebody asks.
  void samples_changed(Index first_changed);

  /// The nodes whose visits have other samples than before though these are as they were, since what the
  /// stroke does later cuts visits or joins them. Some are vacant. Valid until samples change.
  std::span<const Index> parted() const { return parted_; }

  /// The first sample that has gone over to another visit; no_index: none.
  Index first_parted() const { return first_parted_; }

  Index size() const { return static_cast<Index>(nodes_.size()); }
  FrontNode& operator[](Index node) { return nodes_[node]; }
  const FrontNode& operator[](Index node) const { return nodes_[node]; }

  /// The nodes of a vertex, linked by `next`, in no particular order; no_index: none.
  Index first(Index vertex) const {
    if (!own_.holds(vertex)) return first_foreign(vertex);
    const Index node = block_of_[vertex / block_size] + vertex % block_size;
    return node < size() && nodes_[node].vertex() == vertex ? node : no_index;
  }

  /// A node of a vertex that is not own, without a visit. Moves all in memory.
  Index add_foreign(Index vertex) {
    const Index node = add_loose(vertex);
    put(nodes_[node], (*ground_)[vertex]);
    return node;
  }

  /// Whether the node's visit has the sample.
  bool holds(Index node, Index sample) {
    return known_to_hold(nodes_[node], sample) || found_to_hold(node, sample);
  }

  /// The node of the vertex whose visit has the sample, made if need be; adding nodes moves all in memory.
  /// no_index when the sample's disc does not hold the vertex.
  Index at(Index vertex, Index sample) {
    const Index head = first(vertex);
    if (head != no_index && known_to_hold(nodes_[head], sample)) return head;
    return find_or_add(vertex, sample, head);
  }

 private:
  /// What a sample decides: where a node's visit begins, or where it ends.
  struct Decision {
    Index node;
    bool begin;
  };

  bool known_to_hold(const FrontNode& node, Index sample) const {
    return node.run_epoch == epoch_ && samples_->steps(node.run_begin, sample) < node.run_length;
  }
  bool found_to_hold(Index node, Index sample);
  Index find_or_add(Index vertex, Index sample, Index head);
  Index first_foreign(Index vertex) const;
  Index add(Index vertex, Index sample, Index head);
  Index add_block(Index vertex);
  Index add_loose(Index vertex);
  void set_vertex(FrontNode& node, Index vertex) const;
  static void put(FrontNode& node, const GroundVertex& place);
  void begin_visit(FrontNode& node, Index sample) const;
  void forget_changed(Index node);
  bool extends_to(Index node, Index sample);
  bool extends_forward(Index node, Index sample);
  bool extends_backward(Index node, Index sample);
  void find_whole(Index node);
  void set_visit(Index node, const Visit& visit);
  void part(const Decision& decision, Index first_changed);
  void note_parted(Index node, Index sample);
  static void vacate(FrontNode& node);
  Visits visits_to(const FrontNode& node) const { return {*samples_, node.position, node.normal}; }

  const ChartGround* ground_;
  const StrokeSamples* samples_;
  VertexRange own_;
  std::span<Index> block_of_;  ///< [vertex / block_size] its first node, perhaps of another use
  std::unordered_map<Index, Index> foreign_;  ///< first nodes of other vertices
  std::vector<FrontNode> nodes_;
  Index epoch_ = 0;                                ///< counts the changes of the samples
  std::vector<Index> least_changed_;               ///< [epoch] the first sample that has changed after it
  std::vector<std::vector<Decision>> decided_by_;  ///< [sample, and the next to come]
  std::vector<Index> parted_;
  Index first_parted_ = no_index;
};

}  // namespace burin
