#pragma once
#include <string>
#include <vector>

#include "bench/result.h"
#include "bench/scaling.h"

namespace burin {

// The figures of a report, as markup.

/// Share of the events that take at most so long, a plot a case on one scale.
std::string latency_figures(const SuiteResult& result);

/// How the mean time of calls divides among the stages, a bar a case. `calls`: which of a case's.
std::string stage_figure(const SuiteResult& result, CallFigures CaseResult::*calls);

/// Cost over size with its power law.
std::string scaling_figure(const Scaling& scaling);

/// p50 and p95 of events in one result after the other, a plot for each case of the last.
std::string history_figures(const std::vector<SuiteResult>& results);

}  // namespace burin
