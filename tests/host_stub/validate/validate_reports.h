#pragma once
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "../run_command.h"

namespace burin::test {

using Names = std::set<std::string>;

/// The report of the checks of these levels; whatever they find.
inline nlohmann::json report(const std::string& module, const std::string& level) {
  return nlohmann::json::parse(burin({"validate", module, "--json", "--level", level}).out);
}

inline Names failed_checks(const nlohmann::json& report) {
  Names names;
  for (const auto& check : report["checks"])
    if (check["verdict"] != "PASS" && check["verdict"] != "SKIP") names.insert(check["name"]);
  return names;
}

/// What a report tells of a check; a failure of the test if it does not name it.
inline std::string text_of(const nlohmann::json& report, const std::string& name) {
  for (const auto& check : report["checks"])
    if (check["name"] == name) return check["text"];
  ADD_FAILURE() << "no check " << name;
  return {};
}

/// What one check of a module prints.
inline std::string output_of(const std::string& module, const std::string& check) {
  return burin({"validate", module, "--only", check}).out;
}

/// The report on a plugin with a fault, of which the one check must fail.
inline nlohmann::json expect_one_failure(const std::string& plugin, const std::string& check) {
  nlohmann::json found = report(bad_plugin(plugin), "4");
  EXPECT_EQ(failed_checks(found), Names{check}) << plugin;
  return found;
}

}  // namespace burin::test
