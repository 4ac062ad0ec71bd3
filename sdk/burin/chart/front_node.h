#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>

#include <cstdint>
#include <limits>

namespace burin {

/// The graph distance of nodes that the front has not reached.
constexpr float unreached = std::numeric_limits<float>::infinity();

enum class NodeState : std::uint8_t {
  open,     ///< not settled
  inside,   ///< settled within the stroke: leads on
  outside,  ///< settled, and leads nowhere
};

/// A node of the front, a visit of the stroke to a vertex, with all that the fronts of its neighbours ask
/// for: what is asked for most comes first, and the surface is not asked at all.
struct alignas(32) FrontNode {
  Index vertex = no_index;
  Index next = no_index;  ///< node of the same vertex

  /// The samples that are known to belong to the visit, and whether it is known to begin or end with them. A
  /// node without samples is vacant. On closed strokes they may go on across the seam.
  Index run_begin = 0, run_length = 0;
  Index run_epoch = 0;  ///< of the samples when that was found out

  float g = unreached;  ///< graph distance from the stroke, object units
  Index sample = 0;     ///< the one nearest to the node's t, once it has been settled
  NodeState state = NodeState::open;
  bool run_begins : 1 = false;
  bool run_ends : 1 = false;
  bool waiting : 1 = false;  ///< taken back, and not yet offered to its neighbours' fronts
  bool touched : 1 = false;  ///< taken back or settled in the running update
  bool listed : 1 = false;   ///< among the nodes of `sample`
  bool border : 1 = false;   ///< with a neighbour of another part of the front

  ChartFrame frame;
  Vec3f position = Vec3f::Zero(), normal = Vec3f::Zero();  ///< of the vertex
  float gauss = 0;                                         ///< Gauss curvature there
  Index seed = no_index;                                   ///< its seed, if it has one
};

/// The order in which nodes are settled.
inline bool is_upwind(const FrontNode& a, const FrontNode& b) {
  return a.g != b.g ? a.g < b.g : a.vertex < b.vertex;
}

}  // namespace burin
