#pragma once
#include <burin/base/text/json_value.h>

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
  std::size_t ready = 0;    ///< growth from before the mesh is read to the ready session
  std::size_t strokes = 0;  ///< growth by drawing the strokes
  std::size_t peak = 0;     ///< greatest memory of the process
};

/// The result of one case. docs/bench.md documents its JSON.
struct CaseResult {
  std::string name, mesh;
  ScalingAxis axis = ScalingAxis::none;
  std::string hash;                               ///< hash of the result, 16 hexadecimal digits
  std::map<std::string, std::uint64_t> counters;  ///< the same on every machine
  double load_seconds = 0;                        ///< from reading the mesh to the ready session
  double seconds_to_first_event = 0;              ///< since the start of the process
  CallFigures event, end, undo;
  std::vector<double> distribution;    ///< quantiles of the events' times, ms, at 0, 1 ... 100 percent
  std::vector<double> stroke_seconds;  ///< [repeat] total time of all events and ends
  double vertices_per_second = 0;      ///< vertices that moved or got another normal
  double nodes_per_second = 0;         ///< chart nodes computed per second of the chart stage
  CaseMemory memory;
  std::filesystem::path picture;  ///< PNG file of the result; empty: none. Not part of the JSON

  double counter(const std::string& of) const { return static_cast<double>(counters.at(of)); }
};

struct SuiteResult {
  std::string suite;
  std::vector<CaseResult> cases;
};

Json result_json(const SuiteResult& result);

/// Reads a result. Throws FileError if the file is not a result.
SuiteResult read_result(const JsonValue& file);

}  // namespace burin
