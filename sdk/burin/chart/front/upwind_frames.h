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

/// Frames at nodes x that follow from those at their upwind neighbours q, their arms. Several nodes go
/// through the same arithmetic side by side, whose result for a node depends on its arms and their order
/// only.
///
/// Of the arms of a node those count that go with the one that places it nearest to the stroke: where fronts
/// of different parts of the stroke meet, the mean of their coordinates would mean nothing. Arms agree that
/// place x at about the same t, the same d, and with the same direction of the stroke.
///
/// Beyond round ends of the stroke the same steps of second order go along the rays from there; see
/// DistanceRay.
class UpwindFrames {
 public:
  static constexpr std::size_t capacity = 8;

  /// `epsilon`: far below the length of edges, object units. `order`: 1: Eq. 2 and 3 of the paper, weighted
  /// by 1 / (length + epsilon); curvature and stretch stay those of a straight stroke on a plane. 2: second
  /// order in the length of the arms, on curved strokes and surfaces; near corners and focal points, where
  /// lines of constant d turn from arm to arm, by circles. `path`: of the stroke; must outlive the object's
  /// use.
  void set(float epsilon, int order, const StrokePath& path) {
    epsilon_ = epsilon;
    int exponent = 0;
    std::frexp(epsilon, &exponent);
    squared_unit_ = std::ldexp(1.0F, 2 * (exponent + 16));
    order_ = order;
    path_ = &path;
  }

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Begins with the next node, one of at most `capacity`.
  void add_node(const FrontNode& x);

  /// Adds an arm from q, which has a frame, to the last node. `t`: of that frame, unwrapped so that all arms
  /// of the node lie on one line.
  void add_arm(const FrontNode& q, double t);

  /// The frames of all nodes added since clear(), each with at least one arm. Valid until the next call.
  const std::array<ChartFrame, capacity>& compute();

  /// Whether coordinates around the node of this number are others than its frame goes on to: frames of other
  /// parts of the stroke meet it there, or lines of constant d turn within an edge. Valid as long as they
  /// are.
  bool contested(std::size_t node) const { return focal_[node] || left_out_[node]; }

 private:
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
  /// The arms of the same number of all nodes, [lane].
  struct Arms {
    Lanes3 normal, e1;  ///< at q
    Lanes3 chord;       ///< from q to x
    Lanes t;            ///< relative to the node's origin
    Lanes d, curvature, stretch;
    Lanes gauss;         ///< along the edge
    Lanes g, shortfall;  ///< see distance_along()
    Lanes counts;        ///< 0..1

    Lanes length;       ///< |x - q|, object units
    Lanes u, v;         ///< the step from q to x in the basis (e1, e2) of q
    Lanes3 carried;     ///< e1 of q transported to x
    Lanes across, out;  ///< the parts of the step across the ray of q and along it
    /// Near ends only: the rays at q, and where those that are around a round end place x: `told_length` from
    /// that end.
    Rays rays;
    Lanes told_t, told_d, told_length;
    Lanes weight;
    Lanes share_at_x;  ///< of the step over which x's k and J hold, not q's: half of it, but for steps past
                       ///< an end
  };

  void fill_up();
  void walk(Arms& arms) const;
  void walk_exactly(Arms& arms, Eigen::Index lane) const;
  /// An end of the stroke.
  struct End {
    Lanes t;            ///< relative to the nodes' origins
    Lanes most, least;  ///< how far beyond it the nodes may lie, by any of their arms
    float outward = 1;
    bool round = true;
  };
  void find_ends();
  void find_end(End& end, double t, float outward, bool round) const;
  void find_rays(Arms& arms) const;
  static Rays rays_to(const Lanes& past, const Lanes& d);
  void turn_with_rays(const Arms& arms, Lanes& angle) const;
  static void find_round_shapes(const Arms& arms, Lanes& curvature, Lanes& stretch);
  static void go_along_rays(const Rays& rays, const Lanes& inverse_stretch, const Lanes& u, const Lanes& v,
                            Lanes& t, Lanes& d);
  void pass_ends();
  void pass_end(const End& end, const Lanes& t, const Lanes& d);
  void pass_end(const End& end, Eigen::Index lane);
  void place_beyond(const End& end, Eigen::Index lane, float past, float d);
  void shape_at_end(const End& end, Eigen::Index lane, float beyond, float d, float gauss);
  void keep_agreeing();
  void keep_agreeing(Eigen::Index lane);
  void leave_out(std::size_t arm, Eigen::Index lane);
  ChartFrame told_by(const Arms& arms, Eigen::Index lane) const;
  void weigh_second();
  void find_shapes();
  void find_tangents();
  void find_coordinates();
  void find_first_order();
  void find_on_circles(Eigen::Index lane);

  const StrokePath* path_ = nullptr;
  float epsilon_ = 0;
  float squared_unit_ =
      1;  ///< of about an edge: a power of 4 that keeps weights within floats at every scale
  int order_ = 2;
  std::size_t size_ = 0, most_arms_ = 0;
  std::array<std::size_t, capacity> arm_count_{};
  std::array<double, capacity> origin_{};  ///< t of the first arm; the others' are floats relative to it
  Lanes3 position_, normal_;               ///< of the nodes
  Lanes gauss_;
  std::vector<Arms> arms_;
  std::vector<ChartFrame> told_;  ///< [arm] by the arms of one node

  Lanes curvature_, stretch_, t_, d_;
  Lanes3 e1_;
  std::array<bool, capacity> focal_{};     ///< near a corner or a focal point
  std::array<bool, capacity> left_out_{};  ///< where arms do not agree
  std::array<bool, capacity> at_end_{};    ///< where t passes an end of the stroke
  bool near_ends_ = false;                 ///< whether a node may be beyond an end
  std::array<End, 2> ends_;
  Lanes past_, past_d_;  ///< signed way beyond the round end around which a node is, and d there; else 0
  Rays rays_;            ///< of the nodes; near ends only
  std::array<ChartFrame, capacity> frames_;
};

}  // namespace burin
