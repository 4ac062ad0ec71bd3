#pragma once
#include <string>
#include <vector>

#include "bench/result.h"
#include "bench/scaling.h"

namespace burin {

// The figures of a report, as HTML.

/// Cumulative distributions of event times, one plot per case on a common scale.
std::string latency_figures(const SuiteResult& result);

/// The mean time of calls by stage, one bar per case. `calls` selects the kind of calls.
std::string stage_figure(const SuiteResult& result, CallFigures CaseResult::*calls);

/// Cost over size with the fitted power law.
std::string scaling_figure(const Scaling& scaling);

/// p50 and p95 of events over the results, one plot per case of the last result.
std::string history_figures(const std::vector<SuiteResult>& results);

}  // namespace burin
