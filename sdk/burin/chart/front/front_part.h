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
/// settled anew, so that frames are the same in whatever order the news comes.
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
  void take_back_from(const CurveChange& change);
  std::size_t first_parted_segment() const;
  void reach_visits_beside(Index node);
  void take_back(Index node);
  void mark(Index node);
  void take_back_marked();
  void mark_downwind(Index node);
  Index copy_of(std::size_t part, const BorderNode& report);
  void report(Index node);
  void reach_waiting();
  void settle_gathered();
  void settle_as_seed(Index node);
  void settle(Index node, ChartFrame frame);
  void settle_again(Index node, const ChartFrame& frame);
  void follow(const Seeds::Change& change);
  /// Whether a seed gives a node of this g its frame. Its coordinates are exact, while those from elsewhere
  /// may fall short of the truth by the doubt of the path, and often do by just that.
  bool seed_holds(float distance, float g) const {
    return distance <= g + 2 * static_cast<float>(stroke_->path.doubt());
  }
  void make_stale(Index node);
  void settle_or_gather_next();
  void gather(Index node);
  void leave_gathered(Index node);
  void find_upwind(Index node);
  bool within_stroke(Index node);
  void list(Index node);
  float dependence(const Leader::Way& way) const;
  void lead_on(Index node);
  void reach(Index node, float g);
  void reach_from(Index from, const Leader& leader, Index node);
  void lead_to_settled(Index from, const Leader& leader, Index node);
  static void add_arm(FrontNode& node, Index from);
  void touch(Index node);
  bool leads_to(const FrontNode& from, Index to) { return nodes_.holds(to, from.sample); }
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
