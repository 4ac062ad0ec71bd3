#pragma once
#include <burin/base/vector.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace burin {

/// Two faces at an edge from a to b, with the apexes c to the left and d to the right.
struct FaceQuad {
  const Vec3d &a, &b, &c, &d;

  /// Whether the angles opposite to the edge sum up to at most two right angles.
  bool is_delaunay() const {
    const Vec3d ca = a - c, cb = b - c, da = a - d, db = b - d;
    const double sine = ca.cross(cb).norm() * da.dot(db) + da.cross(db).norm() * ca.dot(cb);
    constexpr double enough = -1e-6;  // of the sine of the sum; `sine` is that times four lengths
    return !(sine <
             enough * std::sqrt(ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm()));
  }

  double longest_diagonal() const {
    return std::sqrt(std::max((b - a).squaredNorm(), (d - c).squaredNorm()));
  }

  /// Whether the edge from c to d is at most so far from that from a to b, and both new faces look where the
  /// old ones do.
  bool can_flip(double most_apart) const {
    const Vec3d across = (b - a).cross(d - c);
    if (!(std::abs((c - a).dot(across)) <= most_apart * across.norm())) return false;
    const Vec3d up = (a - c).cross(b - c) + (b - d).cross(a - d);
    const Vec3d first = (a - c).cross(d - c), second = (b - d).cross(c - d);
    constexpr double agrees = 0.7;
    const double least = agrees * up.norm();
    return least > 0 && first.dot(up) > least * first.norm() && second.dot(up) > least * second.norm();
  }
};

}  // namespace burin
