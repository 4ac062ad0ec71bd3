// Makes command-line options of the rows of the setting table. Their texts are converted to JSON values,
// which the same functions read and check as those of files.
#include "options/setting_options.h"

#include <burin/stroke/files/setting_texts.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "options/options.h"

namespace burin {
namespace {

using nlohmann::json;

/// Makes a help text such as "half the width of the stroke, object units (as recorded)".
std::string help_of(const SettingRow& row, std::string_view absent) {
  std::string initial = row.recorded ? std::string(absent) : "";
  if (!row.initial.empty()) initial += (initial.empty() ? "" : ", or ") + row.initial;
  return fmt::format("{}{}{} ({})", row.help, row.unit.empty() ? "" : ", ", row.unit, initial);
}

CLI::Option* repeatable(CLI::Option* option) {
  return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* add_option(CLI::App& command, const SettingRow& row, GivenSettings& given,
                        const std::string& help) {
  const auto take = [&row, &given](const json& value) { row.read(JsonValue::of(value, row.option), given); };
  if (row.form == SettingForm::flag)
    return command.add_flag_callback(
        row.option, [take] { take(true); }, help);
  if (row.form == SettingForm::dynamics) {
    const auto take_all = [take, &row](const std::vector<std::string>& texts) {
      json all = json::array();
      for (const std::string& text : texts) all.push_back(setting_json(row, text, row.option));
      take(all);
    };
    return repeatable(command.add_option_function<std::vector<std::string>>(row.option, take_all, help));
  }
  return command.add_option_function<std::string>(
      row.option, [take, &row](const std::string& text) { take(setting_json(row, text, row.option)); }, help);
}

}  // namespace

void add_setting_options(CLI::App& command, GivenSettings& given, std::span<const std::string_view> keys,
                         std::string_view absent) {
  for (const std::string_view key : keys) {
    const SettingRow& row = setting_row(key);
    CLI::Option* option = add_option(command, row, given, help_of(row, absent));
    if (!row.typed.empty()) option->type_name(row.typed);
    if (!row.needs.empty()) option->needs(setting_row(row.needs).option);
  }
}

void add_all_setting_options(CLI::App& command, GivenSettings& given, std::vector<std::string>& params) {
  std::vector<std::string_view> keys;
  for (const SettingRow& row : setting_table())
    if (row.form != SettingForm::params) keys.push_back(row.key);
  add_setting_options(command, given, keys);
  const SettingRow& row = setting_row("params");
  repeatable(command.add_option(row.option, params, help_of(row, "as recorded")))->type_name(row.typed);
}

}  // namespace burin
