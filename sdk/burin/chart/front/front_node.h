#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// A node of the front, a visit of the stroke to a vertex, with all that the fronts of its neighbours ask
/// for: what is asked for most comes first, and the surface is not asked at all.
struct alignas(64) FrontNode {
  static constexpr std::size_t most_arms = 6;

  FrontKey key = no_index;
  Index next = no_index;  ///< node of the same vertex

  /// The samples that are known to belong to the visit, as of this epoch: all of them, or some in between of
  /// which it may begin or end with the known ones. A node without samples is vacant. On closed strokes they
  /// may go on across the seam.
  Index run_begin = 0, run_length = 0;
  Index run_epoch = 0;  ///< of the samples

  Index sample = 0;     ///< the one nearest to the node's t, once it has been settled
  Index listed_at = 0;  ///< sample under which the part of the front lists it
  NodeState state = NodeState::open;
  std::uint8_t arm_count = 0;  ///< more than most_arms: not all of them are in arms
  bool run_whole : 1 = false;  ///< known up to the last sample
  bool run_begins : 1 = false;
  bool run_ends : 1 = false;
  bool stale : 1 = false;  ///< settled, but upwind frames have changed since: its own is to be computed again
  bool gathered : 1 = false;   ///< about to be settled: its arms are collected
  bool waiting : 1 = false;    ///< taken back, and not yet offered to its neighbours' fronts
  bool touched : 1 = false;    ///< taken back or settled in the running update
  bool listed : 1 = false;     ///< among the nodes of `listed_at`
  bool border : 1 = false;     ///< with a neighbour of another part of the front
  bool contested : 1 = false;  ///< see UpwindFrames::contested(), or its frame was mended

  /// The nodes inside that lead here, in no particular order; while the node is open.
  std::array<Index, most_arms> arms{};
  Index seed = no_index;  ///< its seed, if it has one

  ChartFrame frame;
  Vec3f position = Vec3f::Zero(), normal = Vec3f::Zero();  ///< of the vertex
  float gauss = 0;                                         ///< Gauss curvature there
  float depends_to = -unreached;  ///< arc length; what of the stroke lies beyond had no say in g and frame

  Index vertex() const { return static_cast<Index>(key); }
  float g() const { return g_of(key); }
  void set_g(float g) { key = front_key(g, vertex()); }
};

inline bool is_upwind(const FrontNode& a, const FrontNode& b) { return a.key < b.key; }

}  // namespace burin
