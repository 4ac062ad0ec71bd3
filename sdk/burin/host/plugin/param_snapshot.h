#pragma once
#include <burin/abi/brush.h>
#include <burin/stroke/recording.h>

#include <array>
#include <string>
#include <vector>

namespace burin {

/// The value of one parameter; its declared type defines which member is used.
struct ParamValue {
  std::array<float, 4> numbers{};  ///< four channels of a colour; other types use the first number only
  std::string text;                ///< value of text and file parameters, UTF-8
  std::vector<float> knots;        ///< knots of a curve: x0 y0 x1 y1 ...
};

/// The value of a parameter's setting, or its default if `setting` is null. Throws Error, for example
/// "parameter 'depth' of org.burin.groove: 7 is above the maximum 4", if the setting is of the wrong kind,
/// out of range or not one of the choices, or if there is neither a setting nor a default.
ParamValue resolve_param(const burin_brush_descriptor& brush, const burin_param_info& info,
                         const ParamSetting* setting);

/// The values of all parameters of a brush during a stroke. The ABI structure refers to the object, which
/// must stay in place.
class ParamSnapshot {
 public:
  /// Resolves all parameters. Throws Error as resolve_param() does, and, with a list of the known ones, for a
  /// setting without a parameter.
  ParamSnapshot(const burin_brush_descriptor& brush, const ParamSettings& settings);
  ParamSnapshot(const ParamSnapshot&) = delete;
  ParamSnapshot& operator=(const ParamSnapshot&) = delete;

  const burin_params& abi() const { return params_; }

 private:
  std::vector<ParamValue> values_;
  std::vector<burin_param_value> abi_values_;  ///< point into values_
  burin_params params_{};
};

}  // namespace burin
