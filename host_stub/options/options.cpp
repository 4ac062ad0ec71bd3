// Parses what the options of several commands have in common: numbers, vectors, and parameters NAME=VALUE.
#include "options/options.h"

#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stroke/files/setting_texts.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace burin {
namespace {

Vec3d parse_vector(const std::string& name, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 3)
    throw CLI::ValidationError(name, "takes three numbers x,y,z, not " + quoted_word(text));
  const Vec3d vector((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  if (vector.isZero(0)) throw CLI::ValidationError(name, "must not be zero");
  return vector;
}

/// Accepts the texts for which `good` holds. `wanted`: "a number above 0".
template <class Good>
CLI::Validator texts(const Good& good, const std::string& wanted, const std::string& type) {
  return {[=](std::string& text) {
            return good(text) ? std::string() : fmt::format("must be {}, not {}", wanted, quoted_word(text));
          },
          type};
}

template <class InRange>
CLI::Validator numbers(const InRange& in_range, const std::string& wanted, const std::string& type) {
  const auto good = [in_range](const std::string& text) {
    const auto number = parse_number(text);
    return number && in_range(*number);
  };
  return texts(good, wanted, type);
}

CLI::Validator whole_numbers(std::uint64_t least, const std::string& type) {
  const auto good = [least](const std::string& text) {
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() && number >= least;
  };
  return texts(good, fmt::format("a whole number from {} on", least), type);
}

}  // namespace

const CLI::Validator& positive_number() {
  static const CLI::Validator validator =
      numbers([](double number) { return number > 0; }, "a number above 0", "NUMBER > 0");
  return validator;
}

const CLI::Validator& finite_number() {
  static const CLI::Validator validator = numbers([](double) { return true; }, "a number", "NUMBER");
  return validator;
}

const CLI::Validator& number_from_0() {
  static const CLI::Validator validator =
      numbers([](double number) { return number >= 0; }, "a number from 0 on", "NUMBER >= 0");
  return validator;
}

const CLI::Validator& whole_number_from_0() {
  static const CLI::Validator validator = whole_numbers(0, "NUMBER >= 0");
  return validator;
}

const CLI::Validator& whole_number_from_1() {
  static const CLI::Validator validator = whole_numbers(1, "NUMBER >= 1");
  return validator;
}

CLI::Option* choose(CLI::Option* option, const std::vector<std::string>& words) {
  const std::string wanted =
      words.size() == 1 ? words.front() : fmt::format("one of {}", fmt::join(words, ", "));
  const auto one_of_them = [words, wanted](std::string& text) {
    const auto found = std::ranges::find(words, in_lower_case(text));
    if (found == words.end()) return fmt::format("must be {}, not {}", wanted, quoted_word(text));
    text = *found;
    return std::string();
  };
  return option->transform(CLI::Validator(one_of_them, ""))
      ->type_name(fmt::format("{}", fmt::join(words, "|")));
}

void add_vector_option(CLI::App& command, const std::string& name, std::optional<Vec3d>& vector,
                       const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [name, &vector](const std::string& text) { vector = parse_vector(name, text); }, help)
      ->type_name("X,Y,Z");
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
    settings[name] = is_text(name) ? ParamSetting(value) : param_of_text(value);
  }
  return settings;
}

}  // namespace burin
