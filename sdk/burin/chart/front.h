#pragma once
#include <burin/chart/seeds.h>
#include <burin/chart/upwind.h>
#include <burin/chart/vertex_nodes.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <vector>

namespace burin {

/// The front that spreads a stroke's coordinates over its surroundings, and the coordinates themselves. They
/// are a function of the surface, the seeds, the length and the radius: update() replaces seeds and length
/// and recomputes what follows from the difference, with the result of a fresh start bit for bit.
///
/// Each vertex x that the front reaches has the graph distance g from the seeds and is settled once every
/// neighbour q with (g_q, q) < (g_x, x), in lexicographic order, is: the upwind ones. Settled vertices within
/// the stroke are inside and lead on. When a frame changes, the settled vertices downwind of it are taken
/// back and settled anew.
class Front {
 public:
  /// The surface must outlive the front.
  explicit Front(const Surface& surface) : surface_(&surface), index_(surface.vertex_count()) {}

  /// Forgets everything; the surface may have changed. `radius`: half width of the stroke, object units.
  void restart(double radius, int order);

  /// Makes these the seeds (one a vertex) of a stroke of this length.
  void update(std::span<const Seed> seeds, double length);

  /// The nodes inside, by vertex, ascending. Valid until the next call.
  std::span<const Index> inside() const { return inside_; }
  Index vertex(Index node) const { return index_.vertex(node); }
  const ChartFrame& frame(Index node) const { return nodes_[node].frame; }

 private:
  static constexpr float unreached = std::numeric_limits<float>::infinity();
  enum class State : std::uint8_t { open, inside, outside };

  struct Node {
    float g = unreached;              ///< graph distance from the stroke, object units
    float seed_distance = unreached;  ///< to the foot of its own seed, if it has one
    State state = State::open;
    bool waiting = false;  ///< taken back, and not yet offered to its neighbours' fronts
    bool listed = false;   ///< in inside_
    bool seeded = false;   ///< has a seed in the running update
    ChartFrame frame;
    ChartFrame seed;
  };
  struct Entry {
    float g;
    Index vertex;
    bool operator>(const Entry& other) const {
      return std::pair(g, vertex) > std::pair(other.g, other.vertex);
    }
  };

  Index node_of(Index vertex);
  void replace_seeds(std::span<const Seed> seeds);
  void set_seed(Index node, float distance, const ChartFrame& seed);
  void replace_length(double length);
  void take_back(Index node);
  void take_back_downwind(Index node);
  void reach_waiting();
  void propagate();
  void settle(Index node);
  void lead_on(Index node);
  void reach(Index node, float g);
  void collect_arms(Index node);
  bool within_stroke(const Node& node) const;
  bool is_upwind(Index a, Index b) const;
  float distance_through(Index from, Index to) const;
  void list_inside();

  const Surface* surface_;
  double radius_ = 0, length_ = 0;
  int order_ = 2;
  VertexNodes index_;
  std::vector<Node> nodes_;  ///< [node of index_]
  std::vector<Index> seeds_;
  std::vector<Index> inside_;
  std::vector<Index> settled_;  ///< in the running update
  std::vector<Index> waiting_, stack_;
  std::vector<UpwindArm> arms_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace burin
