#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace burin {

/// The distance of nodes that the front has not reached.
constexpr float unreached = std::numeric_limits<float>::infinity();

enum class NodeState : std::uint8_t {
  open,     ///< not settled
  inside,   ///< settled within the stroke: leads on
  outside,  ///< settled, and leads nowhere
};

/// The order in which nodes are settled: the bits of their distance g from the stroke, which are in order for
/// floats >= 0, above the vertex.
using FrontKey = std::uint64_t;
inline FrontKey front_key(float g, Index vertex) {
  return FrontKey{std::bit_cast<std::uint32_t>(g)} << 32 | vertex;
}
inline float g_of(FrontKey key) { return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32)); }

/// The phase of a node in the front's algorithm. `state`, g and three flags determine it; other combinations
/// of these never occur.
///
///     phase        state              g         stale  gathered  waiting
///     not reached  open               infinite  no     no        no
///     queued       open               finite    no     no        no       in the queue, to be settled
///     gathered     open               finite    no     yes       no       about to be settled
///     settled      inside or outside  finite    no     no        no
///     stale        inside or outside  finite    yes    no        no       in the queue, to be settled again
///     regathered   inside or outside  finite    yes    yes       no       about to be settled again
///     marked       as any of the five phases above               yes      to be taken back
///     taken back   open               infinite  no     no        yes      to be reached anew
///
/// FrontNode's functions go from one to another:
///
///     reach           not reached, queued         -> queued
///                     gathered                    -> gathered, to be followed by leave_gathered
///     gather          queued                      -> gathered
///                     stale                       -> regathered
///     leave_gathered  gathered                    -> queued
///                     regathered                  -> stale
///     settle          queued (by seed), gathered  -> settled
///     make_stale      settled                     -> stale
///     settle_again    stale (by seed), regathered -> settled
///     mark            queued to regathered        -> marked
///                     not reached                 -> taken back
///     take_back       marked                      -> taken back
///     release         taken back                  -> not reached
///
/// A marked node stays marked when it leaves the gathered ones or becomes stale. ChartNodes opens a vacant
/// node that a new visit needs, with an infinite g. Between updates all nodes are either not reached or
/// settled. Copies of the nodes of other parts of the front are either not reached or settled inside; see
/// BorderNode.
enum class NodePhase : std::uint8_t {
  not_reached,
  queued,
  gathered,
  settled,
  stale,
  regathered,
  marked,
  taken_back,
  impossible,
};

/// A node of the front: a visit of the stroke to a vertex. Members that are read most come first. A node has
/// copies of the vertex's data, so that the front need not read the surface.
struct alignas(64) FrontNode {
  static constexpr std::size_t most_leaders = 6;

  FrontKey key = no_index;
  Index next = no_index;  ///< node of the same vertex

  /// The samples that are known to belong to the visit, as of this epoch: all of them, or some in between of
  /// which it may begin or end with the known ones. A node without samples is vacant. On closed strokes they
  /// may go on across the seam. ChartNodes alone writes them and their three flags:
  ///
  ///     visit        length    run_whole  run_begins, run_ends
  ///     vacant       0         no         yes
  ///     known so far 1 or more no         each as far as it is known
  ///     whole        1 or more yes        run_begins; run_ends unless it may go on with samples to come
  Index run_begin = 0, run_length = 0;
  Index run_epoch = 0;  ///< of the samples

  Index sample = 0;     ///< the one nearest to the node's t, once it has been settled
  Index listed_at = 0;  ///< sample under which the part of the front lists it
  NodeState state = NodeState::open;
  std::uint8_t leader_count = 0;  ///< more than most_leaders: not all of them are in leaders
  bool run_whole : 1 = false;     ///< known up to the last sample
  bool run_begins : 1 = false;
  bool run_ends : 1 = false;
  bool stale : 1 = false;  ///< settled, but upwind frames have changed since: its own is to be computed again
  bool gathered : 1 = false;  ///< about to be settled: its upwind edges are collected
  bool waiting : 1 = false;   ///< marked or taken back, and not yet reached from its neighbours
  // In any phase:
  bool touched : 1 = false;    ///< taken back or settled in the running update
  bool listed : 1 = false;     ///< among the nodes of `listed_at`
  bool border : 1 = false;     ///< with a neighbour of another part of the front
  bool contested : 1 = false;  ///< see UpwindFrames::Result, or its frame was mended

  /// The nodes inside that lead here, in no particular order; while the node is open.
  std::array<Index, most_leaders> leaders{};
  Index seed = no_index;  ///< its seed, if it has one

  ChartFrame frame;
  Vec3f position = Vec3f::Zero(), normal = Vec3f::Zero();  ///< of the vertex
  float gauss = 0;                                         ///< Gauss curvature there
  float depends_to = -unreached;  ///< arc length; what of the stroke lies beyond had no say in g and frame

  Index vertex() const { return static_cast<Index>(key); }
  float g() const { return g_of(key); }
  void set_g(float g) { key = front_key(g, vertex()); }

  NodePhase phase() const;

  void reach(float g) {
    assert(is_in({NodePhase::not_reached, NodePhase::queued, NodePhase::gathered}));
    set_g(g);
  }
  void gather() {
    assert(is_in({NodePhase::queued, NodePhase::stale}));
    gathered = true;
  }
  void leave_gathered() {
    assert(gathered && phase() != NodePhase::impossible);
    gathered = false;
  }
  void settle(NodeState as) {
    assert(as != NodeState::open && is_in({NodePhase::queued, NodePhase::gathered}));
    state = as;
    gathered = false;
  }
  void make_stale() {
    assert(is_in({NodePhase::settled, NodePhase::marked}));
    stale = true;
  }
  void settle_again() {
    assert(is_in({NodePhase::stale, NodePhase::regathered}));
    stale = gathered = false;
  }
  void mark() {
    assert(!waiting && phase() != NodePhase::impossible);
    waiting = true;
  }
  void take_back() {
    assert(is_in({NodePhase::marked, NodePhase::taken_back}));
    state = NodeState::open;
    set_g(unreached);
    leader_count = 0;
    depends_to = -unreached;
    stale = gathered = false;
  }
  void release() {
    assert(is_in({NodePhase::taken_back}));
    waiting = false;
  }

 private:
  bool is_in(std::initializer_list<NodePhase> phases) const {
    return std::find(phases.begin(), phases.end(), phase()) != phases.end();
  }
};

inline NodePhase FrontNode::phase() const {
  const bool open = state == NodeState::open, reached = g() != unreached;
  if (open ? stale || (gathered && !reached) : !reached || (gathered && !stale)) return NodePhase::impossible;
  if (waiting) return reached ? NodePhase::marked : NodePhase::taken_back;
  if (!reached) return NodePhase::not_reached;
  if (open) return gathered ? NodePhase::gathered : NodePhase::queued;
  if (!stale) return NodePhase::settled;
  return gathered ? NodePhase::regathered : NodePhase::stale;
}

inline bool is_upwind(const FrontNode& a, const FrontNode& b) { return a.key < b.key; }

}  // namespace burin
