#pragma once
#include <burin/base/vector.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace burin {

/// How long edges may be at a place: so long within a distance of some lines, and longer by `growth` of the
/// distance beyond that. Object units. May be asked from several threads at once.
class EdgeLength {
 public:
  static constexpr double growth = 0.5;

  /// `lines`: polylines, without empty ones; at least one. A line of one point is that point. Radius and edge
  /// are above 0.
  EdgeLength(const std::vector<std::vector<Vec3d>>& lines, double radius, double edge);

  /// In O(log points) where it is longer than edge().
  double at(const Vec3d& place) const;

  double edge() const { return edge_; }
  double radius() const { return radius_; }

  /// Whether the line from one place to the other, where at() is what is given, has a place at which `length`
  /// is more than `factor` times as long as edges may be.
  bool is_exceeded(const Vec3d& from, double at_from, const Vec3d& to, double at_to, double length,
                   double factor) const;

  /// The area within the radius of the lines, if they do not overlap and the surface is flat; object units^2.
  double area() const;

 private:
  struct Segment {
    Vec3d from, to;
  };
  using Box = Eigen::AlignedBox3d;
  double distance(const Vec3d& place) const;
  void nearest_below(std::size_t level, std::size_t node, const Vec3d& place, double& squared) const;

  double radius_, edge_;
  std::vector<Segment> segments_;
  std::vector<std::vector<Box>> levels_;  ///< boxes of runs of segments, then of runs of boxes
};

}  // namespace burin
