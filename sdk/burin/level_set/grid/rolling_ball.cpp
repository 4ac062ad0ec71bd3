// A point is within the fillet if the place of a ball's middle closest to it, at least a radius r from both
// solids, is exactly r from both, and the point lies on the ball's side towards them. With that place at the
// distance D the surface of the ball is where r - D is 0: between the lines on which the ball touches the
// solids this is the fillet, and it goes over into them smoothly. The place is the minimum of |x - p| under
// the two conditions a(x) >= r and b(x) >= r, found by sequential quadratic programming with linearized
// distances a and b.
//
// Voxels cannot hold the gap between two walls that meet at an acute angle: its edge would be ragged, with
// tunnels through it. There the ball has at least the radius of a voxel.
#include <burin/base/parallel.h>
#include <burin/level_set/grid/rolling_ball.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

using Leaf = Grid::TreeType::LeafNodeType;

/// Value and gradient at a place, voxels.
struct Linear {
  double value;
  Vec3d gradient;
};

class Distance {
 public:
  explicit Distance(const Grid& grid) : accessor_(grid.getConstAccessor()), voxel_(grid.voxelSize().x()) {}

  Linear at(const Vec3d& p) const {
    Linear linear{sample(p), {}};
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d half = Vec3d::Unit(axis) / 2;
      linear.gradient[axis] = sample(p + half) - sample(p - half);
    }
    linear.gradient.stableNormalize();
    return linear;
  }

 private:
  double sample(const Vec3d& p) const {
    return static_cast<double>(
               openvdb::tools::BoxSampler::sample(accessor_, openvdb::Vec3d(p.x(), p.y(), p.z()))) /
           voxel_;
  }

  Grid::ConstAccessor accessor_;
  double voxel_;
};

/// The least y with n1.y >= b1 and n2.y >= b2, c = n1.n2.
struct Least {
  Vec3d y = Vec3d::Zero();
  bool by_both = false;
};

Least least(const Vec3d& n1, double b1, const Vec3d& n2, double b2) {
  const double c = n1.dot(n2);
  if (b1 <= 0 && b2 <= 0) return {};
  if (c * b1 >= b2) return {b1 * n1, false};
  if (c * b2 >= b1) return {b2 * n2, false};
  const double whole = 1 - c * c;
  return {((b1 - c * b2) * n1 + (b2 - c * b1) * n2) / whole, true};
}

/// The least radius of the ball between walls whose normals have this scalar product, voxels.
double least_radius(double cosine) {
  constexpr double whole = -0.75;
  return std::clamp((acute_walls - cosine) / (acute_walls - whole), 0., 1.);
}

/// r - D at a place within the fillet; all in voxels. Nothing elsewhere.
std::optional<double> in_fillet(const Distance& first, const Distance& second, const Vec3d& p,
                                double radius) {
  constexpr int steps = 8;
  constexpr double close = 1e-3, parallel = -0.995;
  radius = std::max(radius, least_radius(first.at(p).gradient.dot(second.at(p).gradient)));
  if (!(radius > 0)) return {};
  Vec3d x = p;
  Least found;
  for (int step = 0; step < steps; ++step) {
    const Linear a = first.at(x), b = second.at(x);
    // No ball fits between two walls that face each other.
    if (a.gradient.dot(b.gradient) < parallel) return std::min((a.value + b.value) / 2 - radius, 0.);
    found = least(a.gradient, radius - a.value + a.gradient.dot(x - p), b.gradient,
                  radius - b.value + b.gradient.dot(x - p));
    Vec3d way = p + found.y - x;
    if (const double far = way.norm(); far > radius) way *= radius / far;
    x += way;
    if (way.squaredNorm() < close * close) break;
  }
  if (!found.by_both) return {};
  return radius - found.y.norm();
}

}  // namespace

void add_fillet(Grid& both, const Grid& first, const Grid& second, double radius) {
  const double voxel = both.voxelSize().x();
  const double most_radius = std::max(radius, voxel);
  const auto near = static_cast<float>(most_radius), far = static_cast<float>(2 * most_radius);
  openvdb::tree::LeafManager<Grid::TreeType> leaves(both.tree());
  parallel_blocks(leaves.leafCount(), 1, [&](std::size_t begin, std::size_t end) {
    const Distance a(first), b(second);
    for (std::size_t i = begin; i < end; ++i) {
      Leaf& leaf = leaves.leaf(i);
      const Leaf &one = *first.tree().probeConstLeaf(leaf.origin()),
                 &other = *second.tree().probeConstLeaf(leaf.origin());
      for (openvdb::Index k = 0; k < Leaf::SIZE; ++k) {
        const float least = std::min(one.getValue(k), other.getValue(k)),
                    most = std::max(one.getValue(k), other.getValue(k));
        if (least < -near || least > near || most > far) continue;
        const openvdb::Coord at = leaf.offsetToGlobalCoord(k);
        const std::optional<double> value = in_fillet(a, b, Vec3d(at.x(), at.y(), at.z()), radius / voxel);
        if (value) leaf.setValueOn(k, std::min(leaf.getValue(k), static_cast<float>(*value * voxel)));
      }
    }
  });
}

}  // namespace burin
