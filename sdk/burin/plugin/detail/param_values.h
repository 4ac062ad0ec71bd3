#pragma once
#include <burin/abi/brush.h>
#include <burin/plugin/detail/complete.h>
#include <burin/plugin/detail/error.h>
#include <burin/plugin/detail/views.h>
#include <burin/plugin/params.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace burin::plugin {

/// The value of a curve parameter: linear between knots, constant beyond the first and the last. O(knots) per
/// value.
class Curve {
 public:
  Curve(const float* knots, std::size_t count) : knots_(knots), count_(count) {}

  float operator()(float x) const {
    if (!(x > knots_[0])) return knots_[1];
    for (std::size_t i = 1; i < count_; ++i) {
      const float* left = knots_ + 2 * i - 2;
      const float* right = left + 2;
      if (x < right[0]) return left[1] + (right[1] - left[1]) * ((x - left[0]) / (right[0] - left[0]));
    }
    return knots_[2 * count_ - 1];
  }

 private:
  const float* knots_;
  std::size_t count_;
};

/// The values of a brush's parameters, accessed by their declarations: `in.params[depth][element]`. An access
/// searches the list, so make it once per batch. Valid during the call that received it. Throws Error for a
/// declaration that is missing from the brush's param_list.
class Params {
 public:
  Params(const burin_brush_descriptor& brush, const burin_params* values)
      : brush_(&brush), values_(values ? complete(*values) : burin_params{}) {}

  Floats operator[](const FloatParam& param) const { return number<float>(param.id); }
  Ints operator[](const IntParam& param) const { return number<int>(param.id); }
  Bools operator[](const BoolParam& param) const { return number<bool>(param.id); }
  Ints operator[](const ChoiceParam& param) const { return number<int>(param.id); }
  Colours operator[](const ColourParam& param) const {
    const auto view = [](const burin_floats& floats) { return Floats(floats.data, floats.stride); };
    const burin_param_value& value = find(param.id);
    return {view(value.colour[0]), view(value.colour[1]), view(value.colour[2]), view(value.colour[3])};
  }
  /// The path of the file; empty if the user gave none.
  const char* operator[](const FileParam& param) const { return find(param.id).text; }
  const char* operator[](const TextParam& param) const { return find(param.id).text; }
  Curve operator[](const CurveParam& param) const {
    const burin_param_value& value = find(param.id);
    return {value.knots, value.knot_count};
  }

 private:
  template <class Value>
  View<float, Value> number(const char* id) const {
    const burin_floats& floats = find(id).number;
    return {floats.data, floats.stride};
  }

  const burin_param_value& find(const char* id) const {
    for (std::uint32_t i = 0; i < std::min(brush_->param_count, values_.count); ++i)
      if (std::string_view(brush_->params[i]->id) == id) return values_.values[i];
    throw Error(std::string("no value for parameter '") + id + "': is it in the brush's param_list?",
                BURIN_INVALID_ARGUMENT);
  }

  const burin_brush_descriptor* brush_;
  burin_params values_;
};

}  // namespace burin::plugin
