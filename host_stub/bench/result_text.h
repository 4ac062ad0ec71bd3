#pragma once
#include <string>
#include <vector>

#include "bench/result.h"
#include "bench/scaling.h"

namespace burin {

/// Tables for the terminal: times, throughput and memory per case, then the exponents.
std::string result_text(const SuiteResult& result, const std::vector<Scaling>& scalings);

}  // namespace burin
