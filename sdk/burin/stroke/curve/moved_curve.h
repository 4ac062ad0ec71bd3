#pragma once
#include <burin/stroke/curve/surface_curve.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace burin {

/// How much of the drawn curve a moved point depends on: from the arc length t - behind to t + ahead, object
/// units, >= 0.
struct CurveReach {
  double behind = 0, ahead = 0;
};

/// Where a point of a curve moves: along its tangent e1 and across it, along e2 = n x e1; object units.
struct CurveOffset {
  float along = 0, across = 0;
};

/// The curve of a stroke whose points are moved over the surface. A point moves along the geodesic in the
/// direction of its offset, as far as the offset is long. It stops where the surface ends or folds back
/// within a step. The moved curve is the spline through the moved points, with points as far apart as the
/// drawn curve has them; points that come nearer than a quarter of that to the one before are left out. A
/// moved point has time, pen and speed of the drawn one, since they are those of the hand. Its width is that
/// of its own t.
class MovedCurve {
 public:
  /// Returns the offsets of the drawn curve's points from `first` on. The offset of a point must depend on
  /// the part of the curve within the reach only, to the bit.
  using Offsets = std::function<std::vector<CurveOffset>(const SurfaceCurve& drawn, std::size_t first)>;

  /// `tracer`: that of the drawn curve, which must outlive the object; `radius`: of the stroke, object units.
  MovedCurve(const CurveTracer& tracer, double radius, StrokeWidth width, const CurveReach& reach)
      : tracer_(&tracer), radius_(radius), width_(std::move(width)), reach_(reach) {}

  /// Moves the drawn curve, of which so many first points are final. An open curve must continue the one of
  /// the last call, and costs what it changes; a closed curve is moved as a whole. The result does not depend
  /// on how often the curve was moved before.
  void follow(const SurfaceCurve& drawn, std::size_t final_points, const Offsets& offsets);

  const SurfaceCurve& curve() const { return curve_; }

  /// The number of points of curve() that no longer drawn curve changes: those of which the drawn curve is
  /// final as far as they reach ahead, but the last two.
  std::size_t final_points() const { return final_points_; }

 private:
  struct Knot {
    CurveGround::Point ground_point;
    std::size_t drawn = 0;  ///< index of the drawn point
    Vec3d position() const { return ground_point.at.position.cast<double>(); }
  };
  void move_points(const SurfaceCurve& drawn, std::size_t first, const Offsets& offsets);
  CurveGround::Point moved(const CurvePoint& point, const CurveOffset& offset) const;
  bool step(CurveGround::Point& place, Vec3f& direction, double length, double& left) const;
  void trace(const SurfaceCurve& drawn);
  void trace_segment(const SurfaceCurve& drawn, std::size_t knot);
  const Knot* neighbour(std::size_t knot, std::size_t steps, bool forward) const;
  void append(const CurveGround::Point& place, const Vec3d& direction, const PenAt& pen);
  void close();

  const CurveTracer* tracer_;
  double radius_;
  StrokeWidth width_;
  CurveReach reach_;
  std::size_t settled_ = 0;  ///< number of drawn points whose moved places are final
  std::vector<Knot> knots_;  ///< the moved points that the curve passes through
  SurfaceCurve curve_;
  std::size_t final_segments_ = 0;
  std::size_t final_points_ = 0;
};

}  // namespace burin
