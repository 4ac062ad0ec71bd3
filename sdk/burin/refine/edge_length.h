#pragma once
#include <burin/base/vector.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace burin {

/// How long edges may be at a place: so long within a distance of some segments, and longer by `growth` of
/// the distance beyond that; the least that any segment says. Object units. May be asked from several threads
/// at once.
class EdgeLength {
 public:
  static constexpr double growth = 0.5;

  /// Edges within `radius` of a segment, which may be a point, may be `edge` long; both are above 0.
  struct Around {
    Vec3d from, to;
    double radius, edge;
  };

  /// At least one. Those that follow one another should be near each other.
  explicit EdgeLength(std::vector<Around> segments);

  /// `lines`: polylines, without empty ones; at least one. A line of one point is that point.
  EdgeLength(const std::vector<std::vector<Vec3d>>& lines, double radius, double edge);

  /// In O(log segments) where it is longer than edge().
  double at(const Vec3d& place) const;

  double edge() const { return edge_; }  ///< the least

  /// Whether the line from one place to the other, where at() is what is given, has a place at which `length`
  /// is more than `factor` times as long as edges may be.
  bool is_exceeded(const Vec3d& from, double at_from, const Vec3d& to, double at_to, double length,
                   double factor) const;

 private:
  struct Run {
    Eigen::AlignedBox3d box;
    double radius = 0;  ///< the greatest
    double edge;        ///< the least
  };
  double least_in(const Run& run, const Vec3d& place) const;
  void least_below(std::size_t level, std::size_t node, const Vec3d& place, double& least) const;

  double edge_;
  std::vector<Around> segments_;
  std::vector<std::vector<Run>> levels_;  ///< runs of segments, then runs of runs
};

}  // namespace burin
