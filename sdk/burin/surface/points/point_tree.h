#pragma once
#include <burin/base/vector.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A kd-tree over points, which must stay in place while the tree exists. May be used by several threads at
/// once. A query for k points costs about O(k log n).
class PointTree {
 public:
  struct Near {
    Index point;
    double squared_distance;
  };

  explicit PointTree(std::span<const Vec3f> points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  /// Sets `found` to the `count` points closest to a position, or to all if there are fewer, ordered by
  /// distance, then by index. Which of several equally distant points are included depends on the points
  /// alone.
  void nearest(const Vec3d& place, std::size_t count, std::vector<Near>& found) const;

  /// Sets `found` to the points closer to a position than `distance`, in unspecified order.
  void within(const Vec3d& place, double distance, std::vector<Near>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Appends to `facing` the points of `near` whose normals are within 120 degrees of `normal`, until it holds
/// `count`. The others lie on the opposite side of a thin part.
void keep_facing(std::span<const PointTree::Near> near, std::span<const Vec3f> normals, const Vec3f& normal,
                 std::size_t count, std::vector<PointTree::Near>& facing);

}  // namespace burin
