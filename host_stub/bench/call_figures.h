#pragma once
#include <burin/base/text/json_value.h>
#include <burin/host/event_cost.h>
#include <burin/host/percentile.h>

#include <array>
#include <vector>

#include "system/console.h"

namespace burin {

/// The total time, seconds, and the cost by stage of calls of a session, in the order of the calls.
struct Calls {
  std::vector<double> seconds;
  std::vector<EventCost> costs;

  void append(const Calls& more);
};

/// Statistics of times, milliseconds.
struct TimeFigures {
  double mean = 0;
  Percentiles at;
};

struct CallFigures {
  std::size_t count = 0;
  TimeFigures whole;
  std::array<TimeFigures, stage_count> stages{};  ///< [Stage]
};

CallFigures call_figures(const Calls& calls);

/// The times, milliseconds, that 0, 1 ... 100 percent of all times do not exceed; empty without times.
std::vector<double> distribution(std::vector<double> seconds);

Json call_json(const CallFigures& figures);
CallFigures read_call_figures(const JsonValue& value);

}  // namespace burin
