// Converts the results of a suite to JSON and back. Reading checks that all that reports show is there.
#include "bench/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();

std::string axis_name(ScalingAxis axis) {
  const auto& names = scaling_axis_names();
  return std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.second == axis; })
      ->first;
}

Json memory_json(const CaseMemory& memory, double vertices) {
  const auto per_vertex = [&](std::size_t bytes) { return static_cast<double>(bytes) / vertices; };
  return {{"ready_bytes", memory.ready},
          {"ready_bytes_per_vertex", per_vertex(memory.ready)},
          {"strokes_bytes", memory.strokes},
          {"peak_bytes", memory.peak},
          {"peak_bytes_per_vertex", per_vertex(memory.peak)}};
}

Json case_json(const CaseResult& result) {
  return {{"name", result.name},
          {"mesh", result.mesh},
          {"axis", axis_name(result.axis)},
          {"hash", result.hash},
          {"counters", result.counters},
          {"load_s", result.load_seconds},
          {"seconds_to_first_event", result.seconds_to_first_event},
          {"event_ms", call_json(result.event)},
          {"end_ms", call_json(result.end)},
          {"undo_ms", call_json(result.undo)},
          {"distribution_ms", result.distribution},
          {"stroke_s", result.stroke_seconds},
          {"vertices_per_second", result.vertices_per_second},
          {"nodes_per_second", result.nodes_per_second},
          {"memory", memory_json(result.memory, result.counter("vertices"))}};
}

std::map<std::string, std::uint64_t> read_counters(const JsonValue& value) {
  std::map<std::string, std::uint64_t> counters;
  for (const auto& [name, count] : value.members()) counters[name] = count.whole(0, any);
  for (const char* needed : {"vertices", "triangles", "events", "region"}) value.member(needed);
  return counters;
}

CaseMemory read_memory(const JsonValue& value) {
  const auto bytes = [&](const char* name) { return value.member(name).whole(0, any); };
  return {bytes("ready_bytes"), bytes("strokes_bytes"), bytes("peak_bytes")};
}

CaseResult read_case(const JsonValue& value) {
  CaseResult result;
  result.name = value.member("name").text();
  result.mesh = value.member("mesh").text();
  result.axis = value.member("axis").choice(scaling_axis_names());
  result.hash = value.member("hash").text();
  result.counters = read_counters(value.member("counters"));
  result.load_seconds = value.member("load_s").number();
  result.seconds_to_first_event = value.member("seconds_to_first_event").number();
  result.event = read_call_figures(value.member("event_ms"));
  result.end = read_call_figures(value.member("end_ms"));
  result.undo = read_call_figures(value.member("undo_ms"));
  result.distribution = value.member("distribution_ms").numbers();
  result.stroke_seconds = value.member("stroke_s").numbers();
  if (result.stroke_seconds.empty()) value.member("stroke_s").reject("holds no time");
  result.vertices_per_second = value.member("vertices_per_second").number();
  result.nodes_per_second = value.member("nodes_per_second").number();
  result.memory = read_memory(value.member("memory"));
  return result;
}

}  // namespace

Json result_json(const SuiteResult& result) {
  Json cases = Json::array();
  for (const CaseResult& one : result.cases) cases.push_back(case_json(one));
  return {{"burin_bench", 1}, {"suite", result.suite}, {"cases", cases}};
}

SuiteResult read_result(const JsonValue& file) {
  file.member("burin_bench").whole(1, 1);
  SuiteResult result{file.member("suite").text(), {}};
  for (const JsonValue& item : file.member("cases").items()) result.cases.push_back(read_case(item));
  return result;
}

}  // namespace burin
