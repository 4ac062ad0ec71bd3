#pragma once
#include <burin/abi/ext/curve_filter.h>
#include <burin/deform/evaluate/brush_stroke.h>
#include <burin/stroke/curve/moved_curve.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// What a brush does to the curve of a stroke before it gets a chart: "burin.curve-filter/1". The stroke must
/// outlive it.
class CurveFilter {
 public:
  /// The filter of the stroke's brush, if it has one. `context` is that of the empty stroke. Throws
  /// ContractError "ID: ..." for a reach that is none.
  static std::optional<CurveFilter> of(const BrushStroke& stroke, const burin_stroke_context& context);

  const CurveReach& reach() const { return reach_; }

  /// The offsets of the points of a drawn curve from `first` on. `flags`: BURIN_STROKE_FINAL and _MIRRORED,
  /// where they hold. Throws ContractError where the brush fails, and for offsets that no point can move by.
  std::vector<CurveOffset> offsets(const SurfaceCurve& drawn, std::size_t first, std::uint64_t flags) const;

 private:
  CurveFilter(const BrushStroke& stroke, const burin_curve_filter& filter,
              const burin_stroke_context& context)
      : stroke_(&stroke), filter_(&filter), context_(context) {}
  void check(const CurvePoint& point, const CurveOffset& offset) const;

  const BrushStroke* stroke_;
  const burin_curve_filter* filter_;
  burin_stroke_context context_;
  CurveReach reach_;
};

}  // namespace burin
