#pragma once
#include <burin/chart/front_node.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace burin {

/// The upwind neighbours q of a node x, and the frame at x that they give. Four at a time go through the same
/// arithmetic; the sums are taken in the order in which the arms were added.
///
/// Of the arms those count that go with the one that places x nearest to the stroke: where fronts of
/// different parts of the stroke meet, the mean of their coordinates would mean nothing. Arms agree that
/// place x no farther apart than two edges.
class UpwindArms {
 public:
  UpwindArms();
  ~UpwindArms();

  /// Begins with a node x. `epsilon`: far below the length of edges, object units.
  void begin(const FrontNode& x, float epsilon) {
    x_ = &x;
    epsilon_ = epsilon;
    arms_.clear();
  }

  /// Adds an arm from q, which has a frame. `t`: of that frame, unwrapped so that all arms of x lie on one
  /// line. x and all q must stay in place.
  void add(const FrontNode& q, double t) { arms_.push_back({&q, t}); }

  /// The frame at x of at least one arm by Eq. 2 and 3 of the paper, weighted by 1 / (length + epsilon).
  /// Curvature and stretch stay those of a straight stroke on a plane.
  ChartFrame first_order();

  /// The same, to second order in the length of the arms, on curved strokes and surfaces. Near focal points,
  /// where no such frame is, the first order.
  ChartFrame second_order();

 private:
  using Lanes = Eigen::Array4f;
  struct Lanes3 {
    Lanes x, y, z;
  };
  struct Four;
  /// k and J at x.
  struct Shape {
    float curvature, stretch;
  };
  struct Arm {
    const FrontNode* from;
    double t;
  };

  void walk_edges();
  Four load(std::size_t first) const;
  void keep_agreeing();
  bool all_agree() const;
  bool near_focal_point() const;
  Shape shape_at_zero() const;
  Shape mean_shape() const;
  Vec3f turned_mean(float curvature) const;
  ChartFrame weighted_mean() const;

  const FrontNode* x_ = nullptr;
  float epsilon_ = 0;
  std::vector<Arm> arms_;
  double origin_ = 0;  ///< t of the first arm; the others' are floats relative to it
  std::vector<Four> fours_;
};

}  // namespace burin
