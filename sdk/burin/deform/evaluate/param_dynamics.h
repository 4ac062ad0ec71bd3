#pragma once
#include <burin/abi/brush.h>
#include <burin/stroke/dynamics.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The strength and the parameters of a brush that dynamics drive along a stroke.
class ParamDynamics {
 public:
  /// A parameter that varies.
  struct Param {
    std::uint32_t index = 0;   ///< index in the descriptor
    double before = 0;         ///< value before dynamics
    double low = 0, high = 0;  ///< range of the delivered value
    bool adds = false;         ///< curves are added (angles) instead of multiplied
    bool whole = false;        ///< the value is rounded to a whole number
    TargetDynamics dynamics;
  };

  ParamDynamics() = default;  ///< nothing varies

  /// `before` are the values before dynamics. Throws Error if a target is neither "radius", "strength" nor a
  /// numeric parameter that the brush declares as dynamic, or if a curve is malformed.
  ParamDynamics(const burin_brush_descriptor& brush, const burin_params& before,
                std::span<const Dynamic> dynamics, const DrivenStroke& stroke);

  /// Whether anything varies.
  bool any() const { return !params_.empty() || !strength_.empty(); }
  const std::vector<Param>& params() const { return params_; }

  /// The factor on the strength at a point of the curve; for `loop` see TargetDynamics. Any thread.
  float strength(const PenAt& at, double loop) const;
  /// The value of a parameter at a point of the curve, within its hard range.
  static float value(const Param& param, const PenAt& at, double loop);

 private:
  TargetDynamics strength_;
  std::vector<Param> params_;
};

}  // namespace burin
