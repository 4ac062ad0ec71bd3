#pragma once
#include <burin/base/vector.h>
#include <burin/surface/surface_point.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "region.h"

namespace burin::test {

inline constexpr double unreached = std::numeric_limits<double>::infinity();

/// Computes shortest paths from one point of a region over its triangles, by windows: the lines from one
/// point through part of a side of a triangle, unfolded from triangle to triangle. Lengths are in object
/// units; vertices and triangles have the region's local indices. The region must outlive the object.
class Unfolding {
 public:
  Unfolding(const Surface& surface, const Region& region);

  /// Whether every edge has at most two triangles, and these agree on its direction.
  bool is_manifold() const { return manifold_; }

  /// Sets the targets, the points to which reached() gives the distances.
  void aim_at(std::span<const SurfacePoint> points);

  /// Computes paths from a point of a triangle, or from a vertex. Paths longer than `most`, or longer than
  /// that to the nearest target by more than `beyond_nearest`, may be missed.
  void find_from(Index triangle, const SurfacePoint& from);
  void find_from(Index vertex, double most, double beyond_nearest);

  /// The distances of vertices and targets: exact up to rounding within the limits, otherwise too long or
  /// `unreached`.
  const std::vector<double>& distances() const { return distances_; }
  const std::vector<double>& reached() const { return reached_; }

 private:
  /// Frame: the side runs along x from its start at 0; the triangle that the lines enter lies above, the
  /// point below. Sides: 3 * triangle + i runs from its corner i to the next.
  struct Window {
    Index side;
    double begin, end;  ///< range on the side
    Vec2d source;
    double before;  ///< length of the path to the source

    double distance_to(double x) const;
  };

  /// A window, or a vertex if there is no window, ordered by the shortest path through it.
  struct Event {
    double distance;
    Index vertex;
    std::optional<Window> window;
    bool operator>(const Event& other) const { return distance > other.distance; }
  };

  struct Target {
    std::array<double, 3> weights;
    Vec3d place;
  };

  void clear(double most, double beyond_nearest);
  void run();
  static Index next_side(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  Index begin_of(Index side) const { return region_.corners[side / 3][side % 3]; }
  Index end_of(Index side) const { return begin_of(next_side(side)); }
  double limit() const { return std::min(most_, nearest_ + beyond_nearest_); }
  double length(Index a, Index b) const { return (places_[a] - places_[b]).norm(); }
  double length(Index side) const { return length(begin_of(side), end_of(side)); }
  void relax(Index vertex, double distance);
  void reach(Index target, double distance);
  void reach_inside(Index triangle, const Vec3d& source, double before);
  void open(const Window& window);
  void open_from(const Vec3d& source, double before, Index side);
  void leave(Index vertex, bool bends);
  void enter(const Window& window);
  void reach_through(const Window& window, const Vec2d& apex);

  const Region& region_;
  std::vector<Vec3d> places_;                 ///< [vertex] position
  std::vector<Index> twins_;                  ///< [side] same side of the triangle beyond, or no_index
  std::vector<std::vector<Index>> opposite_;  ///< [vertex] opposite sides of its triangles
  std::vector<double> angles_;                ///< [vertex] sum of angles; infinite on the boundary
  std::vector<Target> targets_;
  std::vector<std::vector<Index>> targets_in_;  ///< [triangle]
  std::vector<double> distances_, reached_;     ///< [vertex], [target]
  double nearest_ = unreached;                  ///< least of reached_
  double most_ = unreached, beyond_nearest_ = unreached;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  bool manifold_ = true;
};

}  // namespace burin::test
