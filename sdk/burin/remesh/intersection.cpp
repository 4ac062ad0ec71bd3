// Finds triangles that go through each other: one has a side that crosses the other one, which the signs of
// the volumes of tetrahedra tell. Candidates come from a tree of boxes, over the triangles along a curve that
// fills space: O(n log n) for triangles that cross few boxes of others.
#include <burin/base/parallel.h>
#include <burin/base/trees/box_tree.h>
#include <burin/base/trees/spatial_order.h>
#include <burin/remesh/intersection.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace burin {
namespace {

using Box = Eigen::AlignedBox3f;

/// Six times the volume of a tetrahedron, positive where d is below the triangle abc.
double volume(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  return (a - d).dot((b - d).cross(c - d));
}

class Crossings {
 public:
  explicit Crossings(const PatchMesh& patch) : patch_(&patch) {}

  bool meet(std::size_t one, std::size_t other) const {
    const Triangle &t = patch_->triangles[one], &u = patch_->triangles[other];
    const auto shared = std::ranges::count_if(t, [&](Index v) { return std::ranges::find(u, v) != u.end(); });
    return shared < 2 && (crosses(t, u) || crosses(u, t));
  }

  /// Rounded to floats, boxes that overlap still do.
  Box box(std::size_t triangle) const {
    Box box;
    for (const Index v : patch_->triangles[triangle]) box.extend(patch_->positions[v].cast<float>());
    return box;
  }

 private:
  const Vec3d& at(Index vertex) const { return patch_->positions[vertex]; }

  /// Whether a side of the first that has no corner of the second goes through that.
  bool crosses(const Triangle& t, const Triangle& u) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = t[i], to = t[(i + 1) % 3];
      if (std::ranges::find(u, from) == u.end() && std::ranges::find(u, to) == u.end() &&
          goes_through(at(from), at(to), u))
        return true;
    }
    return false;
  }

  /// By more than rounding: in a plane all of these volumes are nearly 0, of either sign.
  bool goes_through(const Vec3d& from, const Vec3d& to, const Triangle& u) const {
    const Vec3d &a = at(u[0]), &b = at(u[1]), &c = at(u[2]);
    const double length = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm(), (to - from).norm()});
    const double none = 1e-9 * length * length * length;
    const auto sign = [none](double value) { return value > none ? 1 : value < -none ? -1 : 0; };
    if (sign(volume(a, b, c, from)) * sign(volume(a, b, c, to)) >= 0) return false;
    const int ab = sign(volume(a, b, from, to)), bc = sign(volume(b, c, from, to)),
              ca = sign(volume(c, a, from, to));
    return ab != 0 && ab == bc && bc == ca;
  }

  const PatchMesh* patch_;
};

/// Triangles along a curve through the middles of their boxes, with which a tree has small boxes.
std::vector<Index> along_curve(const std::vector<Box>& boxes) {
  std::vector<Vec3f> middles;
  for (const Box& box : boxes) middles.push_back(box.center());
  return spatial_order(middles);
}

/// The boxes of triangles along the curve, as the tree asks for them and in lanes.
class Boxes {
 public:
  Boxes(const std::vector<Box>& boxes, const std::vector<Index>& order) : order_(&order) {
    for (const Index triangle : order) boxes_.push_back(boxes[triangle]);
  }

  std::size_t size() const { return order_->size(); }
  void extend(Box& box, Index at) const { box.extend(own(at)); }

  Index triangle(Index at) const { return (*order_)[at]; }
  Box own(Index at) const { return boxes_[at]; }
  /// Those of the run that begins there.
  const BoxLanes& run(Index begin) const { return boxes_.run(begin / BoxLanes::count); }

 private:
  const std::vector<Index>* order_;
  LanedBoxes boxes_;
};

/// The query for the triangles later along the curve that a triangle meets; marks both.
class Meeting {
 public:
  Meeting(const Crossings& crossings, const Boxes& items, Index at, std::vector<std::atomic<char>>& marks)
      : crossings_(crossings), items_(items), at_(at), own_(items.own(at)), marks_(marks) {}

  /// 0 for boxes that have a point in common with the triangle's own, else more.
  BoxLanes::Lane nearest(const BoxLanes& boxes) const {
    BoxLanes::Lane apart = BoxLanes::Lane::Zero();
    for (int axis = 0; axis < 3; ++axis)
      apart = apart.max(boxes.low(axis) - own_.max()[axis]).max(own_.min()[axis] - boxes.high(axis));
    return apart;
  }
  bool reaches(float distance) const { return distance == 0; }

  void meet(Index begin, Index end) {
    if (end <= at_ + 1) return;
    const BoxLanes::Lane apart = nearest(items_.run(begin));
    const Index own = items_.triangle(at_);
    for (Index i = std::max(begin, at_ + 1); i < end; ++i) {
      if (!reaches(apart[i - begin])) continue;
      const Index other = items_.triangle(i);
      if (!crossings_.meet(own, other)) continue;
      marks_[own] = 1;
      marks_[other] = 1;
    }
  }

 private:
  const Crossings& crossings_;
  const Boxes& items_;
  Index at_;
  Box own_;
  std::vector<std::atomic<char>>& marks_;
};

}  // namespace

std::vector<Index> crossing_triangles(const PatchMesh& patch) {
  const Crossings crossings(patch);
  std::vector<Box> boxes(patch.triangles.size());
  if (boxes.empty()) return {};
  for (std::size_t t = 0; t < boxes.size(); ++t) boxes[t] = crossings.box(t);
  const std::vector<Index> order = along_curve(boxes);
  const BoxTree<Boxes> tree(Boxes(boxes, order));
  const Boxes& items = tree.items();
  std::vector<std::atomic<char>> marks(boxes.size());
  parallel_blocks(boxes.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      Meeting meeting(crossings, items, static_cast<Index>(at), marks);
      tree.search(meeting);
    }
  });
  std::vector<Index> found;
  for (Index t = 0; t < marks.size(); ++t)
    if (marks[t]) found.push_back(t);
  return found;
}

}  // namespace burin
