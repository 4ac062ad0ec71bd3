#pragma once
#include <burin/chart/front_node.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace burin {

/// Frames at nodes x that follow from those at their upwind neighbours q, their arms. Several nodes go
/// through the same arithmetic side by side, whose result for a node depends on its arms and their order
/// only.
///
/// Of the arms of a node those count that go with the one that places it nearest to the stroke: where fronts
/// of different parts of the stroke meet, the mean of their coordinates would mean nothing. Arms agree that
/// place x no farther apart than two edges.
class UpwindFrames {
 public:
  static constexpr std::size_t capacity = 8;

  /// `epsilon`: far below the length of edges, object units. `order`: 1: Eq. 2 and 3 of the paper, weighted
  /// by 1 / (length + epsilon); curvature and stretch stay those of a straight stroke on a plane. 2: second
  /// order in the length of the arms, on curved strokes and surfaces; near focal points, where no such frame
  /// is, the first.
  void set(float epsilon, int order) {
    epsilon_ = epsilon;
    order_ = order;
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
  /// The arms of the same number of all nodes, [lane].
  struct Arms {
    Lanes3 normal, e1;  ///< at q
    Lanes3 chord;       ///< from q to x
    Lanes t;            ///< relative to the node's origin
    Lanes d, curvature, stretch;
    Lanes gauss;   ///< along the edge
    Lanes counts;  ///< 1 or 0

    Lanes length;    ///< |x - q|, object units
    Lanes u, v;      ///< the step from q to x in the basis (e1, e2) of q
    Lanes3 carried;  ///< e1 of q transported to x
    Lanes weight;
  };

  void fill_up();
  void walk(Arms& arms) const;
  void walk_exactly(Arms& arms, Eigen::Index lane) const;
  void keep_agreeing();
  void keep_agreeing(Eigen::Index lane);
  void weigh_second();
  void find_shapes();
  void find_tangents();
  void find_coordinates();
  void find_first_order();

  float epsilon_ = 0;
  int order_ = 2;
  std::size_t size_ = 0, most_arms_ = 0;
  std::array<std::size_t, capacity> arm_count_{};
  std::array<double, capacity> origin_{};  ///< t of the first arm; the others' are floats relative to it
  Lanes3 position_, normal_;               ///< of the nodes
  Lanes gauss_;
  std::vector<Arms> arms_;

  Lanes curvature_, stretch_, t_, d_;
  Lanes3 e1_;
  std::array<bool, capacity> focal_{};  ///< near a focal point
  std::array<ChartFrame, capacity> frames_;
};

}  // namespace burin
