#pragma once
#include <burin/abi/brush.h>
#include <burin/stroke/dynamics.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The brush's parameters that dynamics drive along a stroke, and its strength.
class ParamDynamics {
 public:
  /// Of a parameter that varies.
  struct Param {
    std::uint32_t index = 0;   ///< of the descriptor
    double before = 0;         ///< its value before dynamics
    double low = 0, high = 0;  ///< what is delivered lies within
    bool adds = false;         ///< angles: the curves are added, not multiplied
    bool whole = false;        ///< rounded
    TargetDynamics dynamics;
  };

  ParamDynamics() = default;  ///< nothing varies

  /// `before`: the values before dynamics. Throws Error where a target is neither "radius", "strength" nor a
  /// numeric parameter that the brush declares as dynamic, or a curve is malformed.
  ParamDynamics(const burin_brush_descriptor& brush, const burin_params& before,
                std::span<const Dynamic> dynamics, const DrivenStroke& stroke);

  /// Whether anything varies.
  bool any() const { return !params_.empty() || !strength_.empty(); }
  const std::vector<Param>& params() const { return params_; }

  /// Factor on the strength at a place of the curve; `loop` as TargetDynamics takes it. Any thread.
  float strength(const PenAt& at, double loop) const;
  /// Value of a parameter there, within its hard range.
  static float value(const Param& param, const PenAt& at, double loop);

 private:
  TargetDynamics strength_;
  std::vector<Param> params_;
};

}  // namespace burin
