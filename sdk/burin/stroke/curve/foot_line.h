#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <vector>

namespace burin {

/// The plane in which a stroke lies, on average, near some t.
struct FootPlane {
  Vec3f position;  ///< object units
  Vec3f normal;    ///< unit
};

/// Moving averages of a stroke's points and normals along its arc length, for brushes that level out bumps
/// shorter than the radius. Any thread.
class FootLine {
 public:
  /// `curve`: at least one point; `reach`: half the length over which to average, object units, > 0. Copies
  /// positions and normals in O(points).
  FootLine(const SurfaceCurve& curve, double reach);

  /// The mean over the part of the curve in [t - reach, t + reach], in O(log points). A t beyond an end of an
  /// open curve counts as the end; closed curves are periodic. If the normals cancel out, the normal is that
  /// of the point at t.
  FootPlane at(double t) const;

 private:
  struct Sum {
    Vec3d position, normal;  ///< integrals over t
  };
  Sum sum_to(double t) const;
  Sum sum_within(double t) const;
  std::size_t segment_at(double t) const;

  std::vector<double> t_;        ///< [point] arc length; a closed curve has its first point again at the end
  std::vector<Vec3d> position_;  ///< [point]
  std::vector<Vec3d> normal_;    ///< [point]
  std::vector<Sum> sums_;        ///< [point] integrals from the first point to this one
  double reach_;
  bool closed_;
};

}  // namespace burin
