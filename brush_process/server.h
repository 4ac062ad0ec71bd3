#pragma once
#include <burin/host/host_extensions.h>

#include <memory>

namespace burin::process {

/// Answers the requests of the host that started this process, until it asks for the end. `extensions`: the
/// services of brushes besides the log. Returns the status to exit with.
int serve(std::unique_ptr<HostExtensions> extensions);

}  // namespace burin::process
