// Converts texts of settings to the JSON values of files, so that the same functions read and check both.
#include <burin/base/text/number_text.h>
#include <burin/base/text/quoted_word.h>
#include <burin/stroke/files/setting_texts.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace burin {
namespace {

using nlohmann::json;

json number_json(const std::string& text) {
  const auto number = parse_number(text);
  if (!number) return text;
  const bool whole = *number >= 0 && *number < 1e15 && *number == std::floor(*number);
  return whole ? json(static_cast<std::uint64_t>(*number)) : json(*number);
}

json numbers_json(const std::string& text) {
  const auto numbers = parse_numbers(text);
  return numbers ? json(*numbers) : json(text);
}

json flag_json(const std::string& text) {
  return text == "true" || text == "false" ? json(text == "true") : json(text);
}

json dynamic_json(const std::string& text, const std::string& typed, const std::string& name) {
  const std::size_t equals = text.find('='), colon = text.find(':', std::min(equals, text.size()));
  if (equals == 0 || colon == std::string::npos) JsonValue::of(text, name).reject_type(typed);
  return {{"target", text.substr(0, equals)},
          {"source", text.substr(equals + 1, colon - equals - 1)},
          {"curve", numbers_json(text.substr(colon + 1))}};
}

/// The two sides of the first '='. Throws FileError, which begins with `name`, without both.
std::pair<std::string, std::string> sides(const std::string& text, const std::string& name) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw FileError(name, "must be NAME=VALUE, not " + quoted_word(text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// Adds one text of a setting to the object of all.
void add_setting(const std::string& text, json& all) {
  const auto [key, value] = sides(text, "settings");
  const auto table = setting_table();
  const auto row = std::ranges::find(table, key, &SettingRow::key);
  if (row == table.end()) throw FileError("settings", "there is no setting " + quoted_word(key));
  json& there = all[key];
  if (row->form == SettingForm::dynamics) {
    there.push_back(setting_json(*row, value, key));
  } else {
    if (!there.is_null()) throw FileError(key, "is given twice");
    there = setting_json(*row, value, key);
  }
}

std::string value_text(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const auto& one : value) {
    if (!text.empty()) text += ',';
    text += value_text(one);
  }
  return text;
}

}  // namespace

json setting_json(const SettingRow& row, const std::string& text, const std::string& name) {
  switch (row.form) {
    case SettingForm::number:
      return number_json(text);
    case SettingForm::numbers:
      return numbers_json(text);
    case SettingForm::flag:
      return flag_json(text);
    case SettingForm::dynamics:
      return dynamic_json(text, row.typed, name);
    default:
      return text;
  }
}

ParamSetting param_of_text(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  const auto numbers = parse_numbers(text);
  if (!numbers) return text;
  if (numbers->size() == 1) return numbers->front();
  return *numbers;
}

void read_setting_texts(std::span<const std::string> texts, const IsTextParam& is_text, GivenSettings& into) {
  json all = json::object();
  std::vector<std::string> params;
  for (const std::string& text : texts) {
    if (text.starts_with("params="))
      params.push_back(text.substr(7));
    else
      add_setting(text, all);
  }
  read_settings(JsonValue::of(std::move(all), "settings"), SettingsOf::suite, into);
  for (const std::string& text : params) {
    const auto [name, value] = sides(text, "params");
    into[&StrokeSettings::params][name] = is_text(name) ? ParamSetting(value) : param_of_text(value);
  }
}

std::vector<std::string> setting_texts(const GivenSettings& given) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  write_settings(given, all);
  std::vector<std::string> texts;
  for (const auto& [key, value] : all.items()) {
    if (key == "params") {
      for (const auto& [name, one] : value.items())
        texts.push_back(fmt::format("params={}={}", name, value_text(one)));
    } else if (key == "dynamics") {
      for (const auto& one : value)
        texts.push_back(fmt::format("dynamics={}={}:{}", value_text(one["target"]), value_text(one["source"]),
                                    value_text(one["curve"])));
    } else if (value.is_boolean() && setting_row(key).form != SettingForm::flag) {
      texts.push_back(
          fmt::format("{}={}", key, value.get<bool>() ? "yes" : "no"));  // `closed`, a choice of words
    } else {
      texts.push_back(fmt::format("{}={}", key, value_text(value)));
    }
  }
  return texts;
}

}  // namespace burin
