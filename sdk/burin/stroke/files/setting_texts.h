#pragma once
#include <burin/stroke/files/setting_table.h>
#include <burin/stroke/param_setting.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

// Settings as texts, as people type them on command lines and as applications in C pass them.
namespace burin {

/// The JSON value of one text of a setting of any form but `params`: of a flag "true" or "false", of dynamics
/// one, "TARGET=SOURCE:X0,Y0,X1,Y1,...". A text that is not of the form stays text, which the row refuses.
/// Throws FileError, which begins with `name`, for dynamics of another form.
nlohmann::json setting_json(const SettingRow& row, const std::string& text, const std::string& name);

/// The value of a parameter: true and false, a number, numbers between commas, else text.
ParamSetting param_of_text(const std::string& text);

/// Whether the value of a parameter is always a text.
using IsTextParam = std::function<bool(const std::string& param)>;

/// Takes texts "KEY=VALUE", with the keys of the table. Only params, "params=NAME=VALUE", and dynamics may be
/// there several times. `is_text` is asked once all others have been taken. Throws FileError that names the
/// setting: for an unknown key, a second text of it, and values that read_settings() would refuse.
void read_setting_texts(std::span<const std::string> texts, const IsTextParam& is_text, GivenSettings& into);

/// The recorded settings that are given as such texts, from which read_setting_texts() makes the same
/// settings.
std::vector<std::string> setting_texts(const GivenSettings& given);

}  // namespace burin
