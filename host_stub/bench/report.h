#pragma once
#include <string>
#include <vector>

#include "bench/result.h"

namespace burin {

/// A result with its name in a report.
struct NamedResult {
  std::string name;
  SuiteResult result;
};

/// Writes result.json and index.html, which is self-contained, to the folder, which is created if needed.
/// `results` holds at least one result, oldest first; the report shows the last one, and the history if there
/// are more. Throws FileError.
void write_bench_report(const std::string& folder, const std::vector<NamedResult>& results);

}  // namespace burin
