// Summarises the times of calls, as a whole and by stage, by their mean and their nearest-rank percentiles,
// and converts these figures to JSON and back. Costs O(n log n) for n calls.
#include "bench/call_figures.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/figures.h"

namespace burin {
namespace {

TimeFigures time_figures(const std::vector<double>& seconds) {
  if (seconds.empty()) return {};
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return {1e3 * sum / static_cast<double>(seconds.size()), in_milliseconds(percentiles(seconds))};
}

Json time_json(const TimeFigures& figures) {
  Json json = {{"mean", figures.mean}};
  json.update(percentiles_json(figures.at));
  return json;
}

TimeFigures read_time_figures(const JsonValue& value) {
  const auto figure = [&](const char* name) { return value.member(name).number(); };
  return {figure("mean"), {figure("p50"), figure("p95"), figure("p99"), figure("max")}};
}

}  // namespace

void Calls::append(const Calls& more) {
  seconds.insert(seconds.end(), more.seconds.begin(), more.seconds.end());
  costs.insert(costs.end(), more.costs.begin(), more.costs.end());
}

CallFigures call_figures(const Calls& calls) {
  CallFigures figures{calls.seconds.size(), time_figures(calls.seconds), {}};
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    std::vector<double> seconds;
    for (const EventCost& cost : calls.costs) seconds.push_back(cost.seconds[stage]);
    figures.stages[stage] = time_figures(seconds);
  }
  return figures;
}

std::vector<double> distribution(std::vector<double> seconds) {
  std::vector<double> at;
  if (seconds.empty()) return at;
  std::sort(seconds.begin(), seconds.end());
  for (std::size_t percent = 0; percent <= 100; ++percent)
    at.push_back(1e3 * seconds[(seconds.size() - 1) * percent / 100]);
  return at;
}

Json call_json(const CallFigures& figures) {
  Json json = {{"count", figures.count}};
  json.update(time_json(figures.whole));
  for (std::size_t stage = 0; stage < stage_count; ++stage)
    json["stages"][std::string(stage_names[stage])] = time_json(figures.stages[stage]);
  return json;
}

CallFigures read_call_figures(const JsonValue& value) {
  CallFigures figures;
  figures.count = value.member("count").whole(0, std::numeric_limits<std::uint64_t>::max());
  figures.whole = read_time_figures(value);
  const JsonValue stages = value.member("stages");
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    if (const auto times = stages.find(std::string(stage_names[stage])))
      figures.stages[stage] = read_time_figures(*times);
  }
  return figures;
}

}  // namespace burin
