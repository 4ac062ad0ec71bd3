#pragma once
#include <burin/base/vector.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A kd-tree over points, which must stay in place while it lives. Any thread, concurrent.
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

  /// Sets `found` to the `count` points closest to a place, or all when there are fewer: by distance, then by
  /// index. Which of equally distant points make up the count depends on the points alone.
  void nearest(const Vec3d& place, std::size_t count, std::vector<Near>& found) const;

  /// Sets `found` to the points closer to a place than `distance`, in any order.
  void within(const Vec3d& place, double distance, std::vector<Near>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Adds those of `near` whose normals stand less than 120 degrees off `normal` to `facing`, until it holds
/// `count`. The rest lies on the other side of a thin part.
void keep_facing(std::span<const PointTree::Near> near, std::span<const Vec3f> normals, const Vec3f& normal,
                 std::size_t count, std::vector<PointTree::Near>& facing);

}  // namespace burin
