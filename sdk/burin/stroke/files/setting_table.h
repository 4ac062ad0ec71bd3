#pragma once
#include <burin/base/text/json_value.h>
#include <burin/stroke/given_settings.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// How a text on the command line becomes the JSON value that suites and recordings have.
enum class SettingForm {
  text,
  number,
  numbers,   ///< between commas
  flag,      ///< there or not
  dynamics,  ///< TARGET=SOURCE:X0,Y0,X1,Y1,..., repeatable
  params,    ///< NAME=VALUE, repeatable
};

/// A setting of a stroke: what command lines, suites, recordings and documents have of it.
struct SettingRow {
  std::string key = {};      ///< of suites and recordings: "pressure_width"
  std::string option = {};   ///< of command lines: "--pressure-width"; made of the key unless given
  std::string help = {};     ///< what it decides, without a full stop
  std::string values = {};   ///< what it takes as JSON, for documents: "0 to 1"
  std::string typed = {};    ///< the same on the command line: "0..1"
  std::string unit = {};     ///< "radii"; empty for none
  std::string initial = {};  ///< what holds where nobody says; empty for nothing
  SettingForm form = SettingForm::text;
  bool recorded = false;   ///< may stand in a recording
  std::string needs = {};  ///< key of the setting without which this one decides nothing; empty for none
  /// Takes the value, or throws FileError that names its place.
  std::function<void(const JsonValue& value, GivenSettings& into)> read = {};
  /// Of a recorded setting: puts it, if given, under its key.
  std::function<void(const GivenSettings& given, nlohmann::ordered_json& into)> write = {};
};

/// All settings that people may give, in the order in which documents list them.
std::span<const SettingRow> setting_table();

/// The row of this key, which there must be.
const SettingRow& setting_row(std::string_view key);

/// Takes from an object all settings that it has, or only those that a recording may have.
enum class SettingsOf { suite, recording };
void read_settings(const JsonValue& object, SettingsOf what, GivenSettings& into);

/// Writes the recorded settings that are given. Throws FileError for what read_settings() would refuse.
void write_settings(const GivenSettings& given, nlohmann::ordered_json& into);

}  // namespace burin
