#pragma once
#include <burin/chart/chart_nodes.h>
#include <burin/chart/seeds.h>
#include <burin/chart/stroke_samples.h>
#include <burin/chart/upwind.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

namespace burin {

/// The front that spreads a stroke's coordinates over its surroundings, and the coordinates themselves. They
/// are a function of the surface, the curve, the radius and the order: update() replaces the curve and
/// recomputes what follows from the difference, with the result of a fresh start bit for bit.
///
/// Nodes are visits of the stroke to vertices. A node leads on to the nodes of the neighbouring vertices
/// whose run holds the sample at its own t. Each node x that the front reaches has the graph distance g from
/// the seeds and is settled once every q that leads on to it with (g_q, q) < (g_x, x), in lexicographic order
/// of g and vertex, is: the upwind ones. Settled nodes within the stroke are inside and lead on. When a frame
/// changes, the settled nodes downwind of it are taken back and settled anew.
class Front {
 public:
  /// Over which the stroke's curvature is estimated, on either side, in shares of the radius.
  static constexpr double curvature_window = 0.25;

  /// The surface must outlive the front.
  explicit Front(const Surface& surface) : surface_(&surface), chart_nodes_(surface), seed_finder_(surface) {}

  /// Forgets everything; the surface may have changed. `radius`: half width of the stroke at width 1, object
  /// units. `order`: 1 or 2.
  void restart(double radius, int order, const Extensions& extensions = {});

  /// Goes over to this curve, of at least one point.
  void update(const SurfaceCurve& curve);

  /// The nodes inside, by vertex, ascending, and visit. Valid until the next call.
  std::span<const Index> inside() const { return inside_; }
  Index vertex(Index node) const { return chart_nodes_.vertex(node); }
  const ChartFrame& frame(Index node) const { return nodes_[node].frame; }

  /// Half width of the stroke at the arc length t, object units.
  double half_width(double t) const { return samples_.half_width(t); }

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
    Index vertex, node;
    bool operator>(const Entry& other) const {
      return std::tie(g, vertex, node) > std::tie(other.g, other.vertex, other.node);
    }
  };

  void replace_curve(const SurfaceCurve& curve);
  void replace_seeds(std::span<const Seed> seeds);
  void set_seed(Index node, float distance, const ChartFrame& seed);
  void take_back(Index node);
  void take_back_downwind(Index node);
  void reach_waiting();
  void propagate();
  void settle(Index node);
  void lead_on(Index node);
  void reach(Index node, float g);
  void collect_arms(Index node);
  ChartFrame frame_from_arms(Index node);
  bool within_stroke(Index node) const;
  bool leads_to(Index from, Index to) const;
  bool is_upwind(Index a, Index b) const;
  float distance_through(Index from, Index to) const;
  void list_inside();
  template <class Visit>
  void for_each_around(Index node, const Visit& visit) const;

  const Surface* surface_;
  double radius_ = 0;
  int order_ = 2;
  Extensions extensions_;
  std::vector<CurvePoint> points_;  ///< of the last curve
  StrokeSamples samples_;
  GeodesicCurvature curvature_;
  ChartNodes chart_nodes_;
  SeedFinder seed_finder_;
  std::vector<Node> nodes_;  ///< [node of chart_nodes_]
  std::vector<Index> seeds_;
  std::vector<Index> inside_;
  std::vector<Index> settled_;  ///< in the running update
  std::vector<Index> waiting_, stack_, ahead_;
  std::vector<UpwindArm> arms_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace burin
