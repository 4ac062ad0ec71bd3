#pragma once
#include <burin/chart/chart.h>
#include <burin/stroke/curve/surface_curve.h>

#include <Eigen/SparseCore>

#include "flat_triangle.h"

namespace burin::paper {

/// A point of the region, by its triangle's corners, that is to lie at a place of the plane.
struct Constraint {
  Triangle vertices;              ///< local
  std::array<double, 3> weights;  ///< their sum is 1
  Vec2d target;
};

/// The vertices of the triangles that the stroke crosses, at their chart coordinates (t, d).
std::vector<Constraint> vertices_near_stroke(const test::Region& region, const Chart& chart,
                                             const SurfaceCurve& curve);

/// Points of the stroke, one in each triangle that it crosses, at (t, 0).
std::vector<Constraint> points_on_stroke(const test::Region& region, const SurfaceCurve& curve);

/// Holds points by stiff springs: as good as fixed (to about 1e-6 of the forces), and it does not matter
/// when several constraints say the same.
class Springs {
 public:
  Springs(std::span<const Constraint> constraints, double stiffness)
      : constraints_(constraints), stiffness_(stiffness) {}

  /// Adds the springs of one coordinate, whose unknowns begin at `first`, to the upper and lower half.
  void add_to(std::vector<Eigen::Triplet<double>>& matrix, Index first) const;

  /// Adds the forces towards the targets; a row for each of `vertices` unknowns.
  void add_to(Parameterization& right_side) const;

 private:
  std::span<const Constraint> constraints_;
  double stiffness_;
};

/// The weight of a constraint, compared with edge weights near 1.
inline constexpr double fixed = 1e6;

/// The largest distance of a constrained point from its target.
double largest_miss(const Parameterization& parameterization, std::span<const Constraint> constraints);

}  // namespace burin::paper
