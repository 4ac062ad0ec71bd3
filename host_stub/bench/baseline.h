#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "bench/json_value.h"
#include "bench/result.h"

namespace burin {

/// What of a result is the same on every machine: hashes and counters.
Json baseline_json(const SuiteResult& result);

/// A line "CASE: COUNTER: was 3, is 4" for each difference of the result from the baseline, in the order of
/// the baseline; cases and counters that only one of them has count. Throws FileError for what is no baseline
/// or is one of another suite.
std::vector<std::string> differences(const JsonValue& baseline, const SuiteResult& result);

}  // namespace burin
