#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <vector>

namespace burin {

/// A plane that a stroke lies in around some t.
struct FootPlane {
  Vec3f position;  ///< object units
  Vec3f normal;    ///< unit
};

/// Means of a stroke's points and normals along it, for what is to level out bumps shorter than the radius.
class FootLine {
 public:
  /// Of a curve of at least one point; `reach`: how far on either side of t means go, object units, > 0.
  /// Copies what it needs, in proportion to the points.
  FootLine(const SurfaceCurve& curve, double reach);

  /// The mean over [t - reach, t + reach], as far as the curve goes; beyond its ends that of the end. A
  /// closed curve goes round. Where normals cancel out, that of the point at t.
  FootPlane at(double t) const;

 private:
  struct Sum {
    Vec3d position, normal;  ///< integrals over t
  };
  Sum sum_to(double t) const;
  Sum sum_within(double t) const;
  std::size_t segment_at(double t) const;

  std::vector<double> t_;        ///< of the points, and of the first point again when the curve is closed
  std::vector<Vec3d> position_;  ///< the same
  std::vector<Vec3d> normal_;
  std::vector<Sum> sums_;  ///< from the first point to each
  double reach_;
  bool closed_;
};

}  // namespace burin
