#pragma once
#include <burin/abi/brush.h>
#include <burin/plugin/detail/complete.h>
#include <burin/plugin/detail/error.h>
#include <burin/plugin/detail/views.h>

#include <string>

namespace burin::plugin {

/// Where a brush writes its results, one element per node; burin/abi/stroke.h describes each output and its
/// value before the call. An accessor throws Error unless BrushInfo::outputs declares the output. Valid
/// during evaluate().
class Outputs {
 public:
  explicit Outputs(const burin_outputs& outputs) : outputs_(complete(outputs)) {}

  /// The displacement from the base surface along e1, e2 and the normal, object units. Initially zero.
  FloatsOut along() const { return floats(outputs_.along, "displacement"); }
  FloatsOut across() const { return floats(outputs_.across, "displacement"); }  ///< along e2, object units
  FloatsOut up() const { return floats(outputs_.up, "displacement"); }  ///< along the normal, object units

  FloatsOut mask() const { return floats(outputs_.mask, "mask"); }  ///< 0..1
  /// Linear RGBA, 0..1.
  ColoursOut colour() const {
    const auto& rgba = outputs_.colour;
    return {floats(rgba[0], "colour"), floats(rgba[1], "colour"), floats(rgba[2], "colour"),
            floats(rgba[3], "colour")};
  }

 private:
  static FloatsOut floats(const burin_floats_out& values, const char* name) {
    if (!values.data)
      throw Error(std::string("the brush writes output '") + name + "' without declaring it",
                  BURIN_INVALID_ARGUMENT);
    return {values.data, values.stride};
  }

  burin_outputs outputs_;
};

}  // namespace burin::plugin
