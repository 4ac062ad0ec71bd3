#pragma once
#include <burin/abi/ext/curve_filter.h>
#include <burin/plugin/batch.h>

#include <cstddef>

namespace burin::plugin {

/// Successive points of the curve as it was drawn, in the order of t; burin/abi/ext/curve_filter.h has the
/// details. Valid during CurveFilter::move().
class CurvePoints {
 public:
  CurvePoints(const burin_brush_descriptor& brush, const burin_stroke_context& context,
              const burin_params* values, const burin_curve_points& points)
      : stroke(context), params(brush, values), points_(complete(points)) {}

  const Stroke stroke;  ///< the drawn one, so far: its length, and whether it is closed
  const Params params;  ///< all numbers uniform: the values before input dynamics

  std::size_t size() const { return points_.count; }  ///< number of points

  /// The input of this name, by point; burin_curve_points tells what it is.
  /// @{
  Floats t() const { return view(points_.t); }
  Vectors position() const { return views(points_.position); }
  Vectors normal() const { return views(points_.normal); }
  Vectors e1() const { return views(points_.e1); }
  /// @}

 private:
  static Floats view(const burin_floats& values) { return {values.data, values.stride}; }
  static Vectors views(const burin_vectors& values) {
    return {view(values.x), view(values.y), view(values.z)};
  }

  burin_curve_points points_;
};

/// How much of the drawn curve a moved point depends on: from t - behind to t + ahead. Object units, >= 0;
/// may be infinite. With an infinite `ahead` the curve is moved when the stroke ends.
struct CurveReach {
  double behind = 0, ahead = 0;
};

/// A second base class of brushes that move the stroke's curve before it gets a chart:
///
///   class Wave : public Brush, public CurveFilter { ... };
///
/// What the brush draws follows the moved curve: its t and d are those of the moved curve.
class CurveFilter {
 public:
  CurveFilter() = default;
  CurveFilter(const CurveFilter&) = delete;
  CurveFilter& operator=(const CurveFilter&) = delete;
  virtual ~CurveFilter() = default;

  /// Does not change during a stroke.
  virtual CurveReach reach() const noexcept { return {}; }

  /// Writes by how much each point moves along e1 and across, along e2, object units; both are 0 before. The
  /// points are a part of the curve, and the stroke may be longer in a later call: what is written for a
  /// point must depend on the stroke within the reach only, to the bit.
  virtual void move(const CurvePoints& points, FloatsOut along, FloatsOut across) const = 0;
};

}  // namespace burin::plugin
