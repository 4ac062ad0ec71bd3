// Parses what the options of several commands have in common: numbers, vectors, and parameters NAME=VALUE.
#include "options/options.h"

#include <burin/base/text/quoted_word.h>
#include <burin/stroke/files/setting_texts.h>

#include <CLI/CLI.hpp>

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
