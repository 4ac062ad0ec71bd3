// Lets dynamic parameters vary over the nodes of a batch, as dynamics of the pen do.
#include "validate/probe/varying_params.h"

#include <algorithm>
#include <cmath>

#include "validate/probe/values.h"

namespace burin::validate {
namespace {

/// Numbers around `middle` by up to a quarter of the range, within it.
std::vector<float> varied(const burin_param_info& info, float middle, const Nodes& nodes) {
  const bool colour = info.type == BURIN_PARAM_COLOUR, whole = info.type != BURIN_PARAM_FLOAT && !colour;
  const float low = colour ? 0 : least_of(info), high = colour ? 1 : greatest_of(info);
  std::vector<float> numbers(nodes.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float moved = middle + 0.25f * (high - low) * std::sin(3 * nodes.t(i));
    numbers[i] = std::clamp(whole ? std::round(moved) : moved, low, high);
  }
  return numbers;
}

}  // namespace

VaryingParams::VaryingParams(const burin_brush_descriptor& brush, const burin_params& constant,
                             const Nodes& nodes)
    : values_(constant.values, constant.values + constant.count) {
  const auto vary = [&](const burin_param_info& info, burin_floats& number) {
    numbers_.push_back(varied(info, *number.data, nodes));
    number = {numbers_.back().data(), 1, 0};
  };
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const burin_param_info& info = *brush.params[i];
    if (!info.dynamic) continue;
    if (info.type >= BURIN_PARAM_FLOAT && info.type <= BURIN_PARAM_CHOICE) vary(info, values_[i].number);
    if (info.type == BURIN_PARAM_COLOUR)
      for (burin_floats& channel : values_[i].colour) vary(info, channel);
  }
}

VaryingParams::Part VaryingParams::from(std::size_t node) const {
  std::vector<burin_param_value> values = values_;
  const auto move_on = [node](burin_floats& number) {
    if (number.data) number.data += node * number.stride;
  };
  for (burin_param_value& value : values) {
    move_on(value.number);
    for (burin_floats& channel : value.colour) move_on(channel);
  }
  return Part(std::move(values));
}

}  // namespace burin::validate
