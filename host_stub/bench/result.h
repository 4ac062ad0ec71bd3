#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bench/call_figures.h"
#include "bench/suite.h"

namespace burin {

/// Physical memory of the case's process, bytes.
struct CaseMemory {
  std::size_t ready = 0;    ///< what the ready session holds: more than before the mesh was read
  std::size_t strokes = 0;  ///< what was added by drawing the strokes
  std::size_t peak = 0;     ///< the most that the process has held
};

/// What one case gave. docs/bench.md describes it as JSON.
struct CaseResult {
  std::string name, mesh;
  ScalingAxis axis = ScalingAxis::none;
  std::string hash;                               ///< of the result, 16 hexadecimal digits
  std::map<std::string, std::uint64_t> counters;  ///< the same on every machine
  double load_seconds = 0;                        ///< from reading the mesh to the ready session
  double seconds_to_first_event = 0;              ///< since the process started
  CallFigures event, end, undo;
  std::vector<double> distribution;    ///< of the events' times, ms, at 0, 1 ... 100 percent
  std::vector<double> stroke_seconds;  ///< [repeat] all events and ends
  double vertices_per_second = 0;      ///< moved or with a new normal
  double nodes_per_second = 0;         ///< chart nodes computed, by time in the chart
  CaseMemory memory;
  std::filesystem::path picture;  ///< PNG file of what the strokes made; empty: none. Not part of the JSON

  double counter(const std::string& of) const { return static_cast<double>(counters.at(of)); }
};

struct SuiteResult {
  std::string suite;
  std::vector<CaseResult> cases;
};

Json result_json(const SuiteResult& result);

/// Throws FileError for what is no result.
SuiteResult read_result(const JsonValue& file);

}  // namespace burin
