#pragma once
#include <burin/abi/brush.h>
#include <burin/stroke/recording.h>

#include <array>
#include <string>
#include <vector>

namespace burin {

/// One parameter's value, of which the declared type uses a part.
struct ParamValue {
  std::array<float, 4> numbers{};  ///< the first alone but for colours
  std::string text;                ///< of text and files, UTF-8
  std::vector<float> knots;        ///< x0 y0 x1 y1 ...
};

/// What a setting says, or the default where there is none. Throws Error, "parameter 'depth' of
/// org.burin.groove: 7 is above the maximum 4": of the wrong kind, out of range, no such choice, or nothing
/// given where the brush has no default.
ParamValue resolve_param(const burin_brush_descriptor& brush, const burin_param_info& info,
                         const ParamSetting* setting);

/// All parameters of a brush as it is to see them during a stroke. Stays in place.
class ParamSnapshot {
 public:
  /// Throws as resolve_param; for a setting that the brush does not know Error naming those it knows.
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
