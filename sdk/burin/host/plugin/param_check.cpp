// Checks the descriptions of a brush's parameters: ids, ranges, choices, knots and defaults.
#include <burin/host/plugin/descriptor_check.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>

namespace burin {
namespace {

bool is_param_id(const char* id) {
  if (!id || *id == '\0') return false;
  return std::string_view(id).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") ==
         std::string_view::npos;
}

std::string range_problem(const burin_param_info& info) {
  if (std::isnan(info.hard_min) || std::isnan(info.hard_max) || info.hard_min > info.hard_max)
    return "its hard range is empty";
  if (!std::isfinite(info.soft_min) || !std::isfinite(info.soft_max)) return "its soft range is not finite";
  if (info.soft_min > info.soft_max) return "its soft range is empty";
  if (info.soft_min < info.hard_min || info.soft_max > info.hard_max)
    return fmt::format("its soft range {} .. {} exceeds the hard range {} .. {}", info.soft_min,
                       info.soft_max, info.hard_min, info.hard_max);
  if (!std::isfinite(info.default_number)) return "its default is not finite";
  if (info.default_number >= info.hard_min && info.default_number <= info.hard_max) return {};
  return fmt::format("its default {} lies outside {} .. {}", info.default_number, info.hard_min,
                     info.hard_max);
}

std::string int_problem(const burin_param_info& info) {
  for (const float number : {info.soft_min, info.soft_max, info.default_number})
    if (std::trunc(number) != number || std::abs(number) > largest_whole_param)
      return fmt::format("{} is no whole number within 2^24", number);
  return range_problem(info);
}

std::string choice_problem(const burin_param_info& info) {
  std::set<std::string_view> ids;
  for (const char* const* choice = info.choices; choice && *choice; ++choice) {
    if (!is_text(*choice)) return "a choice without a proper id";
    if (!ids.insert(*choice).second) return fmt::format("two choices '{}'", *choice);
  }
  if (ids.empty()) return "no choices";
  const float index = info.default_number;
  if (std::trunc(index) == index && index >= 0 && index < static_cast<float>(ids.size())) return {};
  return fmt::format("its default {} is none of its {} choices", index, ids.size());
}

std::string colour_problem(const burin_param_info& info) {
  for (const float channel : info.default_colour)
    if (!(channel >= 0 && channel <= 1)) return fmt::format("its default has a channel of {}", channel);
  return {};
}

std::string curve_problem(const burin_param_info& info) {
  if (!info.default_knots || info.default_knot_count == 0) return "a curve without knots";
  for (std::size_t i = 0; i < info.default_knot_count; ++i) {
    const float* knot = info.default_knots + 2 * i;
    if (!std::isfinite(knot[0]) || !std::isfinite(knot[1])) return "a knot that is not finite";
    if (i > 0 && knot[0] <= knot[-2]) return "knots whose x does not rise";
  }
  return {};
}

std::string text_problem(const char* text) {
  return text && *text && !is_text(text) ? "its default is no text" : "";
}

std::string value_problem(const burin_param_info& info) {
  switch (info.type) {
    case BURIN_PARAM_FLOAT:
      return range_problem(info);
    case BURIN_PARAM_INT:
      return int_problem(info);
    case BURIN_PARAM_BOOL:
      return info.default_number == 0 || info.default_number == 1 ? "" : "its default is neither 0 nor 1";
    case BURIN_PARAM_CHOICE:
      return choice_problem(info);
    case BURIN_PARAM_COLOUR:
      return colour_problem(info);
    case BURIN_PARAM_FILE:
      return text_problem(info.default_file);
    case BURIN_PARAM_TEXT:
      return BURIN_HAS(&info, burin_param_info, default_text) ? text_problem(info.default_text) : "";
    case BURIN_PARAM_CURVE:
      return curve_problem(info);
    default:
      return fmt::format("type {} is unknown", info.type);
  }
}

}  // namespace

std::string param_problem(const burin_param_info& info) {
  if (!BURIN_HAS(&info, burin_param_info, default_knot_count))
    return "a parameter's struct_size is too small";
  if (!is_param_id(info.id)) return "a parameter's id is not of a-z, 0-9 and _";
  if (!is_text(info.name)) return fmt::format("parameter '{}': no proper name", info.id);
  if (info.help && !is_text(info.help)) return fmt::format("parameter '{}': its help is no text", info.id);
  const std::string problem = value_problem(info);
  return problem.empty() ? problem : fmt::format("parameter '{}': {}", info.id, problem);
}

}  // namespace burin
