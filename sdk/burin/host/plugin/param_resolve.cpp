// Converts the setting of a parameter to a value of the declared type and checks its range, or takes the
// default.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/host/plugin/descriptor_check.h>
#include <burin/host/plugin/param_snapshot.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace burin {
namespace {

/// The parameter whose setting is being resolved.
struct Target {
  const burin_brush_descriptor& brush;
  const burin_param_info& info;

  [[noreturn]] void refuse(std::string_view why) const {
    throw Error(fmt::format("parameter '{}' of {}: {}", info.id, brush.id, why));
  }
};

/// The alternative that the parameter's type requires; throws Error if the setting is of another kind.
template <class Kind>
const Kind& expect(const Target& target, const ParamSetting& setting, std::string_view kind) {
  if (const Kind* value = std::get_if<Kind>(&setting)) return *value;
  target.refuse(fmt::format("must be {}", kind));
}

float to_float(const Target& target, double number) {
  const auto value = static_cast<float>(number);
  if (!std::isfinite(value)) target.refuse(fmt::format("{} is out of range", number));
  return value;
}

float number_in_range(const Target& target, double number) {
  const float value = to_float(target, number);
  if (value < target.info.hard_min)
    target.refuse(fmt::format("{} is below the minimum {}", number, target.info.hard_min));
  if (value > target.info.hard_max)
    target.refuse(fmt::format("{} is above the maximum {}", number, target.info.hard_max));
  return value;
}

float whole_number(const Target& target, const ParamSetting& setting) {
  const double number = expect<double>(target, setting, "a whole number");
  if (std::trunc(number) != number || std::abs(number) > largest_whole_param)
    target.refuse(fmt::format("{} is no whole number within 2^24", number));
  return number_in_range(target, number);
}

/// Accepts true and false, as files have, and 1 and 0, as command lines may have.
float truth(const Target& target, const ParamSetting& setting) {
  if (const bool* value = std::get_if<bool>(&setting)) return *value ? 1.0f : 0.0f;
  const double* number = std::get_if<double>(&setting);
  if (!number || (*number != 0 && *number != 1)) target.refuse("must be true or false");
  return static_cast<float>(*number);
}

float choice_index(const Target& target, const ParamSetting& setting) {
  const std::string& id = expect<std::string>(target, setting, "the name of a choice");
  std::string known;
  for (std::size_t i = 0; target.info.choices[i]; ++i) {
    if (target.info.choices[i] == id) return static_cast<float>(i);
    known += (i == 0 ? "" : ", ") + std::string(target.info.choices[i]);
  }
  target.refuse(fmt::format("no choice {}; there are: {}", quoted_word(id), known));
}

std::array<float, 4> colour(const Target& target, const ParamSetting& setting) {
  const auto& channels = expect<std::vector<double>>(target, setting, "four numbers, red green blue alpha");
  if (channels.size() != 4) target.refuse("must be four numbers, red green blue alpha");
  std::array<float, 4> values{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(channels[k] >= 0 && channels[k] <= 1))
      target.refuse(fmt::format("{} is not in 0 .. 1", channels[k]));
    values[k] = static_cast<float>(channels[k]);
  }
  return values;
}

std::vector<float> knots(const Target& target, const ParamSetting& setting) {
  const auto& numbers = expect<std::vector<double>>(target, setting, "numbers x0 y0 x1 y1 ...");
  if (numbers.empty() || numbers.size() % 2 != 0) target.refuse("must be pairs of numbers x y");
  std::vector<float> values;
  for (const double number : numbers) values.push_back(to_float(target, number));
  for (std::size_t i = 2; i < values.size(); i += 2)
    if (values[i] <= values[i - 2]) target.refuse(fmt::format("x = {} does not rise", numbers[i]));
  return values;
}

std::string file(const Target& target, const ParamSetting& setting) {
  const std::string& path = expect<std::string>(target, setting, "the path of a file");
  const bool none = path.empty() && target.info.default_file && *target.info.default_file == '\0';
  if ((path.empty() && !none) || path.find('\0') != std::string::npos)
    target.refuse("must be the path of a file");
  return path;
}

/// Accepts a line of text, and a number, since a command line cannot distinguish numbers from text.
std::string text(const Target& target, const ParamSetting& setting) {
  if (const double* number = std::get_if<double>(&setting)) return fmt::format("{}", *number);
  const std::string& line = expect<std::string>(target, setting, "a line of text");
  if (!line.empty() && !is_text(line.c_str())) target.refuse("must be a line of UTF-8 text");
  return line;
}

const char* default_text(const burin_param_info& info) {
  const bool has = BURIN_HAS(&info, burin_param_info, default_text) && info.default_text;
  return has ? info.default_text : "";
}

ParamValue default_value(const Target& target) {
  const burin_param_info& info = target.info;
  ParamValue value;
  switch (info.type) {
    case BURIN_PARAM_COLOUR:
      std::copy_n(info.default_colour, 4, value.numbers.begin());
      break;
    case BURIN_PARAM_FILE:
      if (!info.default_file) target.refuse("a file must be given");
      value.text = info.default_file;
      break;
    case BURIN_PARAM_TEXT:
      value.text = default_text(info);
      break;
    case BURIN_PARAM_CURVE:
      value.knots.assign(info.default_knots, info.default_knots + std::size_t{2} * info.default_knot_count);
      break;
    default:
      value.numbers[0] = info.default_number;
  }
  return value;
}

}  // namespace

ParamValue resolve_param(const burin_brush_descriptor& brush, const burin_param_info& info,
                         const ParamSetting* setting) {
  const Target target{brush, info};
  if (!setting) return default_value(target);
  ParamValue value;
  switch (info.type) {
    case BURIN_PARAM_FLOAT:
      value.numbers[0] = number_in_range(target, expect<double>(target, *setting, "a number"));
      break;
    case BURIN_PARAM_INT:
      value.numbers[0] = whole_number(target, *setting);
      break;
    case BURIN_PARAM_BOOL:
      value.numbers[0] = truth(target, *setting);
      break;
    case BURIN_PARAM_CHOICE:
      value.numbers[0] = choice_index(target, *setting);
      break;
    case BURIN_PARAM_COLOUR:
      value.numbers = colour(target, *setting);
      break;
    case BURIN_PARAM_FILE:
      value.text = file(target, *setting);
      break;
    case BURIN_PARAM_TEXT:
      value.text = text(target, *setting);
      break;
    default:
      value.knots = knots(target, *setting);
  }
  return value;
}

}  // namespace burin
