#pragma once
#include <burin/host/replay.h>

#include <cstddef>
#include <string>
#include <vector>

#include "system/console.h"

namespace burin {

/// What a run of `burin replay` measured.
struct ReplaySummary {
  std::vector<std::string> files;  ///< the recordings, in the order in which they were drawn
  ReplayResult result;             ///< of all of them; latencies rising, no costs
  std::size_t surface_vertices = 0;
  double seconds_to_first_event = 0;  ///< since the process started
  std::size_t peak_memory = 0;        ///< bytes
};

/// Adds what one more recording gave.
void add_result(ReplaySummary& summary, ReplayResult result);

Json summary_json(const ReplaySummary& summary);
std::string summary_text(const ReplaySummary& summary);

}  // namespace burin
