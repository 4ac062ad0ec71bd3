#pragma once
#include <burin/base/vector.h>

#include <utility>
#include <vector>

namespace burin::c {

/// The triangles of a surface as a caller's list of them goes: what is not there any more leaves the list,
/// the rest keeps its order, and new ones come behind. Triangles are told apart by their three vertices, in
/// order.
class ToldTriangles {
 public:
  explicit ToldTriangles(std::vector<Triangle> triangles) : list_(std::move(triangles)) {}

  const std::vector<Triangle>& list() const { return list_; }

  /// The triangles of the list before the last update that it removed, ascending, and those that it added.
  const std::vector<Index>& removed() const { return removed_; }
  const std::vector<Triangle>& added() const { return added_; }

  /// Leaves the list as it is.
  void keep() {
    removed_.clear();
    added_.clear();
  }

  /// Makes the list one of these triangles. O(n log n).
  void update(const std::vector<Triangle>& now);

 private:
  std::vector<Triangle> list_;
  std::vector<Index> removed_;
  std::vector<Triangle> added_;
};

}  // namespace burin::c
