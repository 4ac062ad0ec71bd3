#pragma once
#include <burin/abi/brush.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validate/probe/check.h"

namespace burin::validate {

/// A value for each parameter of a brush.
class Values {
 public:
  /// The defaults, but for values that the subject has. Files that the user must choose are the stamp of the
  /// subject, which outlives the object. Throws Error for a value that a parameter cannot have.
  Values(const burin_brush_descriptor& brush, const Subject& subject);
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;

  /// Sets every number to the ends of its range: the hard one, or the soft one where that is infinite, or its
  /// default where both are.
  void set_least();
  void set_greatest();

  /// Sets every number, colour and choice to a random value in its range.
  void set_random(std::uint64_t seed);

  /// Sets a number, or all channels of a colour, whatever its range.
  void set_number(std::uint32_t index, float number);

  /// Multiplies lengths. Returns whether all stay in their ranges.
  bool scale_lengths(float factor);

  /// The text of a text or file parameter.
  const std::string& text(std::uint32_t index) const { return texts_[index]; }
  void set_text(std::uint32_t index, std::string text);

  /// Makes the files that the user must choose the solid of the subject. Returns whether anything changes.
  bool choose_solids();

  /// Whether the brush has a file parameter without a default, for which the subject has no value.
  bool needs_file() const { return needs_file_; }

  /// The numbers as `--param` takes them: "height=0.25, count=3".
  std::string told() const;

  const burin_params& abi();

 private:
  void set_numbers(const std::function<float(const burin_param_info&)>& number);

  /// The subject's value of a parameter, or null.
  const std::string* given(std::uint32_t index) const;

  /// Makes a value of such a text.
  void set_given(std::uint32_t index, const std::string& text);

  /// Whether the user must choose this file, and has not.
  bool is_to_choose(std::uint32_t index) const;

  const burin_brush_descriptor& brush_;
  const Subject& subject_;
  std::vector<std::array<float, 4>> numbers_;
  std::vector<std::string> texts_;
  std::vector<std::vector<float>> knots_;  ///< x0 y0 x1 y1 ..., empty for the default ones
  std::vector<burin_param_value> values_;
  burin_params params_{};
  bool needs_file_ = false;
};

/// Ends of the range of a number that hosts pass.
float least_of(const burin_param_info& info);
float greatest_of(const burin_param_info& info);

}  // namespace burin::validate
