#pragma once
#include <burin/host/isolate/shared_memory.h>
#include <sys/types.h>

#include <vector>

#include "served_brush.h"

namespace burin::process {

/// Starts a thread for each lane, which serves it until the process ends. Returns the system's numbers of the
/// threads. The brush must stay until the process ends.
std::vector<pid_t> start_lane_threads(std::byte* memory, ServedBrush& brush);

}  // namespace burin::process
