#pragma once
#include <burin/host/replay.h>

#include <cstddef>
#include <string>
#include <vector>

#include "system/console.h"

namespace burin {

/// The measurements of a run of `burin replay`.
struct ReplaySummary {
  std::vector<std::string> files;  ///< the recordings, in the order of drawing
  ReplayResult result;             ///< merged result of all recordings; latencies ascending, no costs
  std::size_t surface_vertices = 0;
  double seconds_to_first_event = 0;  ///< since the start of the process
  std::size_t peak_memory = 0;        ///< bytes
};

/// Adds the result of one more recording.
void add_result(ReplaySummary& summary, ReplayResult result);

Json summary_json(const ReplaySummary& summary);
std::string summary_text(const ReplaySummary& summary);

}  // namespace burin
