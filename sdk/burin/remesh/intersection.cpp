// Finds triangles that go through each other: one has a side that crosses the other one, which the signs of
// the volumes of tetrahedra tell. Candidates come from a tree of boxes.
#include <burin/base/parallel.h>
#include <burin/remesh/intersection.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <unsupported/Eigen/BVH>

namespace burin {
namespace {

using Box = Eigen::AlignedBox3d;
using Boxes = Eigen::KdBVH<double, 3, std::size_t>;

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

  Box box(std::size_t triangle) const {
    Box box;
    for (const Index v : patch_->triangles[triangle]) box.extend(patch_->positions[v]);
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

/// Looks through the tree for a triangle that meets one.
struct Search {
  const Crossings& crossings;
  std::size_t one;
  Box box;

  bool found = false;

  // Eigen calls them by these names.
  // NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Box& other) const { return box.intersects(other); }
  bool intersectObject(std::size_t other) {
    found = other != one && crossings.meet(one, other);
    return found;
  }
  // NOLINTEND(readability-identifier-naming)
};

}  // namespace

std::vector<Index> crossing_triangles(const PatchMesh& patch) {
  const Crossings crossings(patch);
  const std::size_t count = patch.triangles.size();
  std::vector<std::size_t> triangles;
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < count; ++t) {
    triangles.push_back(t);
    boxes.push_back(crossings.box(t));
  }
  const Boxes tree(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
  std::vector<char> crossing(count, 0);
  parallel_blocks(count, 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      Search search{crossings, t, boxes[t]};
      Eigen::BVIntersect(tree, search);
      crossing[t] = search.found;
    }
  });
  std::vector<Index> found;
  for (Index t = 0; t < count; ++t)
    if (crossing[t]) found.push_back(t);
  return found;
}

}  // namespace burin
