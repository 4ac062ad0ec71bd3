#pragma once
#include <string>
#include <vector>

#include "bench/result.h"

namespace burin {

/// A result with what a report calls it.
struct NamedResult {
  std::string name;
  SuiteResult result;
};

/// Writes result.json and index.html, which needs nothing besides itself, into the folder, creating it where
/// needed. `results`: oldest first, at least one; the report shows the last, and the way to it if there are
/// more. Throws FileError.
void write_bench_report(const std::string& folder, const std::vector<NamedResult>& results);

}  // namespace burin
