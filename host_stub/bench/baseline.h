#pragma once
#include <burin/base/text/json_value.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/result.h"

namespace burin {

/// The parts of a result that are the same on every machine: hashes and counters.
Json baseline_json(const SuiteResult& result);

/// A line "CASE: COUNTER: was 3, is 4" for each difference of the result from the baseline, in the order of
/// the baseline. A case or counter that only one of them has is a difference. Throws FileError if the file is
/// not a baseline, or is one of another suite.
std::vector<std::string> differences(const JsonValue& baseline, const SuiteResult& result);

}  // namespace burin
