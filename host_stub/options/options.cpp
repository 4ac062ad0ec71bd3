#include "options/options.h"

#include <burin/base/quoted_word.h>
#include <burin/stroke/files/recording_faults.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "options/stroke_choices.h"

namespace burin {
namespace {

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// All numbers between commas, or nothing when one of them is none.
std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = text.find(',');
    const auto number = parse_number(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

ParamSetting parse_setting(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  const auto numbers = parse_numbers(text);
  if (!numbers) return text;
  if (numbers->size() == 1) return numbers->front();
  return *numbers;
}

Vec3d parse_point(const std::string& name, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 3)
    throw CLI::ValidationError(name, "takes three numbers x,y,z, not " + quoted_word(text));
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

Vec3d parse_vector(const std::string& name, const std::string& text) {
  const Vec3d vector = parse_point(name, text);
  if (vector.isZero(0)) throw CLI::ValidationError(name, "must not be zero");
  return vector;
}

/// "TARGET=SOURCE:x0,y0,x1,y1,...".
Dynamic parse_dynamic(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':', std::min(equals, text.size()));
  if (equals == 0 || colon == std::string::npos)
    throw CLI::ValidationError("--dynamic", "takes TARGET=SOURCE:x0,y0,x1,y1,..., not " + quoted_word(text));
  const std::string source = text.substr(equals + 1, colon - equals - 1);
  const auto known = source_named(source);
  if (!known)
    throw CLI::ValidationError("--dynamic",
                               "has no source " + quoted_word(source) + "; there are: " + source_names());
  const auto curve = parse_numbers(std::string_view(text).substr(colon + 1));
  if (!curve)
    throw CLI::ValidationError("--dynamic", "takes numbers x0,y0,x1,y1,... in " + quoted_word(text));
  const Dynamic dynamic{text.substr(0, equals), *known, *curve};
  if (const std::string_view fault = fault_of(dynamic); !fault.empty())
    throw CLI::ValidationError("--dynamic", std::string(fault) + ", not " + quoted_word(text));
  return dynamic;
}

Stabilising parse_stabilising(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const auto amount =
      colon == std::string::npos ? std::nullopt : parse_number(std::string_view(text).substr(colon + 1));
  if ((kind != "string" && kind != "exponential") || !amount || *amount <= 0)
    throw CLI::ValidationError(
        "--stabilise", "takes string:LENGTH or exponential:SECONDS, above 0, not " + quoted_word(text));
  return {kind == "string" ? Stabilising::Kind::string : Stabilising::Kind::exponential, *amount};
}

/// Accepts numbers from 0 to 1.
const CLI::Validator& share() {
  static const CLI::Validator validator(
      [](std::string& text) {
        const auto number = parse_number(text);
        return number && *number >= 0 && *number <= 1
                   ? std::string()
                   : "must be a number from 0 to 1, not " + quoted_word(text);
      },
      "0..1");
  return validator;
}

}  // namespace

const CLI::Validator& positive_number() {
  static const CLI::Validator validator(
      [](std::string& text) {
        const auto number = parse_number(text);
        return number && *number > 0 ? std::string() : "must be a number above 0, not " + quoted_word(text);
      },
      "NUMBER > 0");
  return validator;
}

const CLI::Validator& finite_number() {
  static const CLI::Validator validator(
      [](std::string& text) {
        return parse_number(text) ? std::string() : "must be a number, not " + quoted_word(text);
      },
      "NUMBER");
  return validator;
}

void add_vector_option(CLI::App& command, const std::string& name, std::optional<Vec3d>& vector,
                       const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [name, &vector](const std::string& text) { vector = parse_vector(name, text); }, help)
      ->type_name("X,Y,Z");
}

void add_point_option(CLI::App& command, const std::string& name, Vec3d& point, const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [name, &point](const std::string& text) { point = parse_point(name, text); }, help)
      ->type_name("X,Y,Z");
}

void add_stroke_options(CLI::App& command, std::optional<Closure>& closure, double& pressure_width,
                        Join& join) {
  command
      .add_option_function<std::string>(
          "--closed", [&closure](const std::string& name) { closure = closure_names().at(name); },
          "whether strokes go around: yes, no, or auto, where the pen came back; as recorded unless given")
      ->check(CLI::IsMember({"yes", "no", "auto"}));
  command
      .add_option("--pressure-width", pressure_width,
                  "how much of the width the pen's pressure decides: 0, nothing, to 1")
      ->check(share())
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--join", [&join](const std::string& name) { join = join_names().at(name); },
          "where strokes bend sharper than their radius: round (the default), smooth, miter or overlap")
      ->check(CLI::IsMember({"round", "smooth", "miter", "overlap"}));
}

void add_follow_option(CLI::App& command, std::optional<double>& follow) {
  command
      .add_option(
          "--follow", follow,
          "how much of the relief strokes feel: 0, what is wider than the brush, to 1, every bump; as\n"
          "recorded, or 0, unless given")
      ->check(share());
}

void add_input_options(CLI::App& command, std::vector<Dynamic>& dynamics, Stabilising& stabilising) {
  command
      .add_option_function<std::vector<std::string>>(
          "--dynamic",
          [&dynamics](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) dynamics.push_back(parse_dynamic(text));
          },
          "what varies along the stroke: radius, strength or a parameter of the brush, multiplied (an angle: "
          "added to) by what the curve makes of " +
              source_names() + "; repeatable, instead of the recorded ones of that target")
      ->type_name("TARGET=SOURCE:X0,Y0,X1,Y1,...")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option_function<std::string>(
          "--stabilise", [&stabilising](const std::string& text) { stabilising = parse_stabilising(text); },
          "calm the samples: string:LENGTH pulls the brush on a string, in units of the recording's space; "
          "exponential:SECONDS lets it lag behind")
      ->type_name("KIND:AMOUNT");
}

ParamSettings parse_param_settings(const std::vector<std::string>& texts,
                                   const std::function<bool(const std::string& name)>& is_text) {
  ParamSettings settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw CLI::ValidationError("--param", "takes NAME=VALUE, not " + quoted_word(text));
    }
    const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
    settings[name] = is_text(name) ? value : parse_setting(value);
  }
  return settings;
}

}  // namespace burin
