#pragma once
#include <burin/base/index_set.h>
#include <burin/chart/front/bucket_queue.h>
#include <burin/chart/front/chart_nodes.h>
#include <burin/chart/front/leader.h>
#include <burin/chart/front/seeds.h>
#include <burin/chart/front/upwind_frames.h>
#include <burin/chart/path/front_stroke.h>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// What a change of the curve leaves as it was.
struct CurveChange {
  Index first_sample;         ///< the first that differs
  double unchanged_t;         ///< what depends on lower t only is as it was, unless something upwind changes
  std::size_t first_segment;  ///< the first whose seeds may differ
};

/// How a node stands that another part of the front has to know of.
struct BorderNode {
  Index node = no_index;  ///< of the part that reports it
  Index vertex = no_index;
  Index sample = 0;     ///< see FrontNode
  bool inside = false;  ///< or open, or outside, which is the same to others
  float g = unreached;
  ChartFrame frame;

  bool operator==(const BorderNode&) const = default;
};

/// The front on a range of vertices. Nodes of other vertices beside them are copies of what their own parts
/// report.
///
/// Each node x that the front reaches has the least distance g at which its seed or the frame of an upwind
/// node places it, and is settled once every q that leads on to it with (g_q, q) < (g_x, x), in lexicographic
/// order of g and vertex, is: the upwind ones. Nearer parts of the stroke so settle a node before farther
/// ones come by. When a frame changes, the settled nodes downwind of it are computed again, or taken back and
/// settled anew, so that frames do not depend on the order of updates. NodePhase says what may become of a
/// node.
class FrontPart {
 public:
  /// `blocks` as ChartNodes takes it. All must outlive the object.
  FrontPart(const ChartGround& ground, const FrontStroke& stroke, std::span<Index> blocks)
      : ground_(&ground),
        stroke_(&stroke),
        nodes_(ground, stroke.samples, blocks),
        seeds_(ground),
        inside_(ground.vertex_count()) {}

  /// Forgets everything, and takes over these vertices.
  void restart(VertexRange own);

  /// Follows a change of the curve. What follows from it waits for advance().
  void change(const CurveChange& change);

  /// Takes in what another part reports, which has this number.
  void receive(std::size_t part, std::span<const BorderNode> reports);

  /// Settles nodes until the lowest g that waits is `limit` or more.
  void advance(float limit);

  /// The lowest g that waits; unreached: none.
  float least_g() { return queue_.empty() ? unreached : queue_.top().g(); }

  /// What has changed at the border since the last call. Valid until the next call.
  std::span<const BorderNode> reports();

  /// Nodes taken back or settled since the last call of change(), in no particular order.
  std::span<const Index> touched() const { return touched_; }

  /// The nodes of own vertices, and copies of others'.
  const ChartNodes& nodes() const { return nodes_; }
  bool owns(const FrontNode& node) const { return own_.holds(node.vertex()); }

  /// The own nodes inside, ascending by vertex and t.
  std::vector<const FrontNode*> inside();

  /// Nodes settled and queue entries pushed since the last call of change().
  std::uint64_t settled() const { return settled_; }
  std::uint64_t pushes() const { return pushes_; }

 private:
  // The numbers are those of the steps in docs/architecture.md.

  // (2) Seeds.

  /// Handles a changed seed. The node is taken back if its g came from the seed or the seed is now nearer;
  /// if only its frame came from the seed it becomes stale.
  void follow_seed(const Seeds::Change& change);

  /// Whether a node of this g takes its frame from its seed at this distance. Coordinates of a seed are
  /// exact, while propagated distances may be too short by the doubt of the path, and often are by just that
  /// much.
  bool seed_holds(float distance, float g) const {
    return distance <= g + 2 * static_cast<float>(stroke_->path.doubt());
  }

  // (3) Pop.

  /// Pops the first entry of the queue. Unless the entry is outdated, its node is settled by its seed or
  /// gathered.
  void settle_or_gather_next();

  // (4) Gather.

  /// Adds a node with its upwind edges to frames_.
  void gather(Index node);

  /// Fills upwind_ with the upwind nodes that lead to a node, in ascending order of vertex and t, so that
  /// sums have a fixed order.
  void find_upwind(Index node);

  /// Removes a node from the gathered ones before it is settled.
  void leave_gathered(Index node);

  /// Whether a node leads to another: the other's visit contains the sample at the node's t.
  bool leads_to(const FrontNode& from, Index to) { return nodes_.holds(to, from.sample); }

  // (5) Compute, (6) mend.

  /// Computes and mends the frames of the gathered nodes, and settles them.
  void settle_gathered();

  // (7) Settle.

  /// Settles a node by its seed.
  void settle_as_seed(Index node);

  /// Stores a node's frame, decides whether it is inside, and if so leads on from it. A stale node is settled
  /// again instead.
  void settle(Index node, ChartFrame frame);

  /// Stores the new frame of a stale node, whose g has not changed. If the frame differs, nodes downwind
  /// become stale or are taken back. If the node changes sides or leads to other nodes, it is taken back
  /// itself.
  void settle_again(Index node, const ChartFrame& frame);

  /// Whether the node's coordinates are within the stroke's width and their foot is in the node's own visit.
  bool within_stroke(Index node);

  /// Lists a settled node under the last sample that it depends on.
  void list(Index node);

  /// Records that a node was taken back or settled in this update.
  void touch(Index node);

  // (8) Lead on.

  /// Reaches the open nodes around a node that was just settled inside. Nodes downwind that were settled
  /// before it are marked or become stale. Nodes that are taken back are left to reach_waiting().
  void lead_on(Index node);

  /// Adds the edge from a node inside to an open node, and reaches the open node by it.
  void reach_from(Index from, const Leader& leader, Index node);

  /// Marks a settled node, or makes it stale, because of an edge from a node upwind that was settled after
  /// it.
  void lead_to_settled(Index from, const Leader& leader, Index node);

  /// Lowers the g of a node and puts it into the queue, if this g is lower than its own.
  void reach(Index node, float g);

  /// Adds a node inside to those that lead to a node, unless it is there.
  static void add_leader(FrontNode& node, Index from);

  /// The arc length up to which the stroke influences a node that is reached by this way.
  float dependence(const Leader::Way& way) const;

  // (9) Repair.

  /// Takes back the settled nodes that depend on what has changed of the curve.
  void take_back_from(const CurveChange& change);

  /// The first segment with places nearest to a sample that has gone over to another visit.
  std::size_t first_parted_segment() const;

  /// Reaches new nodes of a node's vertex from the settled nodes around it.
  void reach_visits_beside(Index node);

  /// Takes back a node and all settled nodes that have their g from it.
  void take_back(Index node);

  /// Marks a node, if it is the part's own and not marked or taken back already.
  void mark(Index node);

  /// Marks the nodes that have their g from a node inside. Other nodes downwind of it become stale.
  void mark_downwind(Index node);

  /// Takes back all marked nodes, and all nodes that have their g from them.
  void take_back_marked();

  /// Reaches the nodes that were taken back, by their seeds and from the settled nodes around them.
  void reach_waiting();

  /// Queues a node whose g stays to be computed again, if it was settled or gathered.
  void make_stale(Index node);

  // (10) Exchange.

  /// Returns the copy of a node of another part; no_index if no own vertex is beside it.
  Index copy_of(std::size_t part, const BorderNode& report);

  /// Adds a node of the border to reports_ if it differs from what was last reported.
  void report(Index node);

  /// Calls `visit` with the nodes of the neighbouring vertices.
  template <class Visit>
  void for_each_around(Index node, const Visit& visit) const {
    for (const Index neighbour : ground_->neighbours(nodes_[node].vertex())) {
      for (Index around = nodes_.first(neighbour); around != no_index; around = nodes_[around].next)
        visit(around);
    }
  }

  const ChartGround* ground_;
  const FrontStroke* stroke_;
  VertexRange own_;
  ChartNodes nodes_;
  Seeds seeds_;
  BucketQueue queue_;
  IndexSet inside_;
  UpwindFrames frames_;
  std::array<Index, UpwindFrames::capacity> gathered_{};  ///< nodes of frames_, or no_index
  std::vector<std::vector<Index>> of_sample_;             ///< settled nodes, and some that have moved on
  std::vector<Index> touched_, waiting_, upwind_;
  std::size_t taken_back_ = 0;  ///< of waiting_, the first so many; the rest is marked only
  std::vector<Index> border_;   ///< nodes with neighbours of other parts, touched since the last reports()
  std::unordered_map<Index, BorderNode> reported_;  ///< what others know of nodes
  std::vector<BorderNode> reports_;
  std::vector<std::unordered_map<Index, Index>> copies_;  ///< [part] its nodes' copies here
  std::uint64_t settled_ = 0, pushes_ = 0;
};

}  // namespace burin
