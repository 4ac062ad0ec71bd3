#pragma once
#include <burin/base/vector.h>
#include <burin/surface/triangle_mesh.h>

#include <functional>
#include <optional>
#include <vector>

namespace burin::test {

/// The value and the derivatives of a height field z = f(x, y).
struct Height {
  double f, fx, fy, fxx, fxy, fyy;
};
using HeightField = std::function<Height(double x, double y)>;

/// A shuffled, irregular mesh of a height field over [-1.3, 1.3]^2, with this many cells per side.
TriangleMesh field_mesh(const HeightField& field, int cells);

/// A plane curve (x, y)(s), s in [0, 1], below the stroke, with its derivative.
struct PlaneCurve {
  std::function<Vec2d(double)> place, derivative;
};

/// The exact stroke coordinates on a height field, by shooting geodesics (Runge-Kutta of fourth order)
/// from the curve at right angles to it and solving for start and length (Newton).
class ShootingOracle {
 public:
  ShootingOracle(HeightField field, PlaneCurve curve);

  /// The arc length of the whole curve on the surface.
  double length() const { return lengths_.back(); }
  Vec3d place(double s) const;

  struct Coordinates {
    double t, d;  ///< d > 0 on the left seen from above
  };
  /// The solution near the guess; nothing if Newton's method does not converge to 1e-10.
  std::optional<Coordinates> solve(const Vec2d& x, const Coordinates& guess) const;

 private:
  Vec2d shoot(double s, double d) const;
  double parameter_at(double t) const;
  double length_at(double s) const;

  HeightField field_;
  PlaneCurve curve_;
  std::vector<double> lengths_;  ///< [i] arc length at s = i / (size - 1)
};

}  // namespace burin::test
