#pragma once
#include <burin/chart/front/front_node.h>
#include <burin/chart/path/distance_ray.h>
#include <burin/chart/path/stroke_path.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace burin {

/// Computes frames at nodes x from those at their upwind neighbours q, along the upwind edges from q to x.
/// Several nodes go through the same arithmetic side by side, one in each lane; the result for a node depends
/// on its own edges and their order only.
///
/// Of a node's edges those count that agree with the one that places it nearest to the stroke: where fronts
/// of different parts of the stroke meet, the mean of their coordinates would mean nothing. Edges agree that
/// place x at about the same t, the same d, and with the same direction of the stroke.
///
/// Beyond round ends of the stroke the same steps of second order go along the rays from there; see
/// DistanceRay.
class UpwindFrames {
 public:
  static constexpr std::size_t capacity = 8;
  using LaneFlags = std::array<bool, capacity>;

  /// `epsilon`: far below the length of edges, object units. `order`: 1: Eq. 2 and 3 of the paper, weighted
  /// by 1 / (length + epsilon); curvature and stretch stay those of a straight stroke on a plane. 2: second
  /// order in the length of the edges, on curved strokes and surfaces; near corners and focal points, where
  /// lines of constant d turn from edge to edge, by circles. `path`: of the stroke; must outlive the object's
  /// use.
  void set(float epsilon, int order, const StrokePath& path) {
    epsilon_ = epsilon;
    int exponent = 0;
    std::frexp(epsilon, &exponent);
    squared_unit_ = std::ldexp(1.0F, 2 * (exponent + log2_edge_over_epsilon));
    order_ = order;
    path_ = &path;
  }

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Begins with the next node, one of at most `capacity`.
  void add_node(const FrontNode& x);

  /// Adds the upwind edge from q, which has a frame, to the last node. `t`: of that frame, unwrapped so that
  /// all edges of the node lie on one line.
  void add_edge(const FrontNode& q, double t);

  /// What follows for the nodes added since clear(), by the order in which they were added.
  struct Result {
    std::array<ChartFrame, capacity> frames;
    /// Whether coordinates around the node are others than its frame goes on to: frames of other parts of the
    /// stroke meet it there, or lines of constant d turn within an edge.
    LaneFlags contested{};
    /// The arc length beyond which the stroke has no say in the frame, object units.
    std::array<double, capacity> depends_to{};
  };

  /// Each node has at least one edge.
  Result compute();

 private:
  /// An edge is about 1/32 of the radius, and epsilon the rounding of the radius.
  static constexpr int log2_edge_over_epsilon = 16;

  using Lanes = Eigen::Array<float, static_cast<int>(capacity), 1>;
  struct Lanes3 {
    Lanes x, y, z;
    void set(Eigen::Index lane, const Vec3f& value) {
      x[lane] = value.x();
      y[lane] = value.y();
      z[lane] = value.z();
    }
    Vec3f get(Eigen::Index lane) const { return {x[lane], y[lane], z[lane]}; }
  };
  /// The rays of frames; see DistanceRay.
  struct Rays {
    Eigen::Array<bool, static_cast<int>(capacity), 1> from_end;
    Lanes ahead, left, length, inverse_length;
  };

  /// One upwind edge of each node, [lane]: the first of all nodes, the second of all, and so on. Steps write
  /// what stands below their names; later steps only read it.
  struct Edges {
    // add_edge() and fill_up()
    Lanes3 normal, e1;  ///< at q
    Lanes3 chord;       ///< from q to x
    Lanes t;            ///< relative to the node's origin
    Lanes d, curvature, stretch;
    Lanes gauss;         ///< along the edge
    Lanes g, shortfall;  ///< see distance_along()
    Lanes counts;        ///< 0..1

    // walk()
    Lanes length;    ///< |x - q|, object units
    Lanes u, v;      ///< the step from q to x in the basis (e1, e2) of q
    Lanes3 carried;  ///< e1 of q transported to x

    // find_reach()
    Lanes reach;  ///< how far along the stroke the edge may lead

    // find_ends()
    Lanes across, out;  ///< the parts of the step across the ray of q and along it
    /// Near ends only: the rays at q, and where those that are around a round end place x: `placed_length`
    /// from that end.
    Rays rays;
    Lanes placed_t, placed_d, placed_length;

    // weigh_second()
    Lanes weight;

    // find_ends(), and pass_ends() for steps past an end
    Lanes share_at_x;  ///< of the step over which x's k and J hold, not q's: half of it but past an end
  };

  /// An end of the stroke.
  struct End {
    Lanes t;            ///< relative to the nodes' origins
    Lanes most, least;  ///< how far beyond it the nodes may lie, by any of their edges
    float outward = 1;
    bool round = true;
  };
  struct Ends {
    std::array<End, 2> ends;
    bool near = false;  ///< whether a node may be beyond one of them; if not nothing else is set
  };
  /// k and J of the nodes.
  struct Shapes {
    Lanes curvature, stretch;
  };
  struct FoundShapes {
    Shapes shapes;
    LaneFlags focal{};  ///< near a corner or a focal point
  };
  /// The nodes after the ends of the stroke have been looked at.
  struct PassedEnds {
    Shapes shapes;
    bool near = false;   ///< as in Ends
    LaneFlags at_end{};  ///< where t passes an end of the stroke
    Lanes past, past_d;  ///< near ends only: signed way beyond the round end around which a node is, and d
                         ///< there; else 0
    Rays rays;           ///< near ends only
  };
  /// Frames of the nodes; t relative to their origins.
  struct Frames {
    Lanes t, d;
    Lanes3 e1;
    Shapes shapes;
    LaneFlags focal{};  ///< as in FoundShapes
  };

  // The steps of compute(), in order. They take what the steps before have found, and change nothing but
  // edges_.

  // (1) Lanes without a node, and edges that a node lacks, repeat others.
  void fill_up();
  // (2) Steps from q to x.
  void walk(Edges& edges) const;
  void walk_exactly(Edges& edges, Eigen::Index lane) const;
  Lanes find_reach();
  // (3) How near the ends of the stroke are, and the rays of edges that are beyond one.
  Ends find_ends();
  End find_end(double t, float outward, bool round) const;
  static void find_rays(Edges& edges, const Ends& ends);
  static Rays rays_to(const Lanes& past, const Lanes& d);
  // (4) Edges that do not agree with the best one count for less, or not. Returns where some do not count.
  LaneFlags keep_agreeing(bool near_ends);
  bool keep_agreeing(Eigen::Index lane, bool near_ends);
  std::size_t find_nearest(Eigen::Index lane, bool near_ends);
  float turn_along(std::size_t edge, Eigen::Index lane) const;
  void leave_out(std::size_t edge, Eigen::Index lane);
  // (5) Means of first order, with which that order ends.
  Frames first_order() const;
  // (6) to (9) The second order.
  Frames second_order(const Ends& ends);
  // (6) Weights, and k and J.
  void weigh_second();
  FoundShapes find_shapes(bool near_ends) const;
  static void find_round_shapes(const Edges& edges, Shapes& shapes);
  // (7) k and J where t passes an end, and the rays of nodes beyond one.
  PassedEnds pass_ends(const Ends& ends, const Shapes& shapes);
  void pass_end(const End& end, const Lanes& t, const Lanes& d, PassedEnds& passed);
  void pass_end(const End& end, Eigen::Index lane, PassedEnds& passed);
  static void place_beyond(const End& end, Eigen::Index lane, float past, float d, PassedEnds& passed);
  void shape_at_end(const End& end, Eigen::Index lane, float beyond, float d, float gauss,
                    Shapes& shapes) const;
  // (8) Directions e1, then t and d between the frames of q and x.
  Lanes3 find_tangents(const PassedEnds& passed) const;
  static void turn_with_rays(const Edges& edges, const PassedEnds& passed, Lanes& angle);
  Frames find_coordinates(const PassedEnds& passed, const Lanes3& e1) const;
  static void go_along_rays(const Rays& rays, const Lanes& inverse_stretch, const Lanes& u, const Lanes& v,
                            Lanes& t, Lanes& d);
  // (9) Instead of (6) to (8), the frames of nodes near a corner or a focal point.
  void find_on_circles(Eigen::Index lane, const PassedEnds& passed, Frames& frames) const;
  // (10) Means that are farther from the stroke than the node's g give way to the nearest edge.
  bool tells_too_far(const ChartFrame& frame, Eigen::Index lane) const;
  ChartFrame of_nearest(Eigen::Index lane, bool near_ends);
  // (4), (7), (9) The frame that an edge by itself gives.
  ChartFrame propagated_along(const Edges& edges, Eigen::Index lane, bool near_ends) const;

  const StrokePath* path_ = nullptr;
  float epsilon_ = 0;
  /// The square of about an edge's length, a power of 4: keeps weights within floats at every scale.
  float squared_unit_ = 1;
  int order_ = 2;

  // The nodes and edges that were added.
  std::size_t size_ = 0, most_edges_ = 0;
  std::array<std::size_t, capacity> edge_count_{};
  std::array<double, capacity> origin_{};  ///< t of the first edge; the others' are floats relative to it
  Lanes3 position_, normal_;               ///< of the nodes
  Lanes gauss_, g_;
  std::vector<Edges> edges_;

  std::vector<ChartFrame> propagated_;  ///< scratch: [edge] of one node
};

}  // namespace burin
