#pragma once
#include <burin/abi/ext/volume.h>
#include <burin/plugin/brush.h>

#include <cstdint>

namespace burin::plugin {

/// What becomes of a solid unless the user says otherwise.
enum class SolidUse : std::uint32_t {
  separate = BURIN_SOLID_SEPARATE,          ///< a part of its own, beside the surface
  unite = BURIN_SOLID_UNION,                ///< part of the surface
  difference = BURIN_SOLID_DIFFERENCE,      ///< the surface loses it
  intersection = BURIN_SOLID_INTERSECTION,  ///< the surface keeps only what is in it
};

/// Where a solid is and how fine it is: what burin_solid_plan says. Object units.
struct SolidPlan {
  double h_min = 0, h_max = 0;  ///< heights over the surface between which the solid lies
  double detail = 0;            ///< the narrowest wall or gap that must not be lost, above 0
  SolidUse use = SolidUse::separate;
};

/// A brush that makes a solid along its stroke, in the coordinates (t, d, h), h the height over the surface:
/// what no displacement of a surface can, chains and screws. `BrushInfo::outputs` may be 0.
class SolidBrush : public Brush {
 public:
  /// Of the finished stroke.
  virtual SolidPlan solid(const Stroke& stroke, const Params& params) const = 0;

  /// Writes the signed distance to the solid at every element, negative inside, object units, as if t, d and
  /// h were Cartesian; away from the solid a lower bound is enough. Figures of shapes.h are distances in a
  /// plane of two of them. Runs on several threads at once.
  virtual void distance(const Batch& in, Floats h, FloatsOut out) const = 0;

  /// Nothing, unless overridden: what the brush does where no solid is asked for.
  void evaluate(const Batch&, const Outputs&) const override {}
};

}  // namespace burin::plugin
