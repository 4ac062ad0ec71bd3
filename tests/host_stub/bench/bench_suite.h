#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_stub/run_command.h"

namespace burin::test {

/// A folder with a small sphere, a stroke and suites of them.
class BenchFolder : public CommandFolder {
 public:
  BenchFolder();

  /// A case that draws the stroke on the sphere, with these members besides.
  static nlohmann::json bench_case(const std::string& name,
                                   const nlohmann::json& members = nlohmann::json::object());

  /// Writes suite.json and returns its path.
  std::string write_suite(const std::vector<nlohmann::json>& cases) const;

  /// A program that answers as burin does, its output changed by an expression of sed.
  std::string changed_burin(const std::string& expression) const;
};

}  // namespace burin::test
