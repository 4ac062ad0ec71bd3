#pragma once
#include <burin/plugin/params.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace burin::plugin {

namespace detail {

template <class Param>
constexpr burin_param_info info_of_any(const Param& param, burin_param_type type, bool dynamic) {
  burin_param_info info{};
  info.struct_size = sizeof info;
  info.type = type;
  info.id = param.id;
  info.name = param.name;
  info.help = param.help;
  info.unit = BURIN_UNIT_NONE;
  info.dynamic = dynamic;
  return info;
}

constexpr void set_ranges(burin_param_info& info, Range hard, Range soft) {
  info.hard_min = hard.low;
  info.hard_max = hard.high;
  const Range slider = soft.low == soft.high ? hard : soft;
  info.soft_min = slider.low;
  info.soft_max = slider.high;
}

constexpr burin_param_info info_of(const FloatParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_FLOAT, param.dynamic);
  info.unit = param.unit;
  set_ranges(info, param.hard, param.soft);
  info.default_number = param.default_value;
  return info;
}

constexpr burin_param_info info_of(const IntParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_INT, param.dynamic);
  set_ranges(info, param.hard, param.soft);
  info.default_number = static_cast<float>(param.default_value);
  return info;
}

constexpr burin_param_info info_of(const BoolParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_BOOL, param.dynamic);
  set_ranges(info, {0, 1}, {0, 1});
  info.default_number = param.default_value ? 1.0f : 0.0f;
  return info;
}

constexpr burin_param_info info_of(const ChoiceParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_CHOICE, param.dynamic);
  const Range all{0, static_cast<float>(param.choices.size()) - 1};
  set_ranges(info, all, all);
  info.default_number = static_cast<float>(param.default_value);
  info.choices = param.choices.data();
  return info;
}

constexpr burin_param_info info_of(const ColourParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_COLOUR, param.dynamic);
  for (std::size_t i = 0; i < 4; ++i) info.default_colour[i] = param.default_value[i];
  return info;
}

constexpr burin_param_info info_of(const FileParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_FILE, false);
  info.default_file = param.default_value;
  return info;
}

constexpr burin_param_info info_of(const TextParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_TEXT, false);
  info.default_text = param.default_value;
  return info;
}

constexpr burin_param_info info_of(const CurveParam& param) {
  burin_param_info info = info_of_any(param, BURIN_PARAM_CURVE, false);
  info.default_knots = param.default_value.data();
  info.default_knot_count = static_cast<std::uint32_t>(param.default_value.size() / 2);
  return info;
}

}  // namespace detail

/// The parameters of a brush, in the order in which users see them. A brush class has the list as
/// `static constexpr auto params`.
template <class... Params>
constexpr std::array<burin_param_info, sizeof...(Params)> param_list(const Params&... params) {
  return {detail::info_of(params)...};
}

}  // namespace burin::plugin
