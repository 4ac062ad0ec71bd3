#pragma once
#include <burin/abi/host.h>

namespace burin_probe {

/// Checks the host that a brush is created with: its members, and its services.
void check_host(const burin_host* host);

/// Checks that the host is still what it was when the brush was created.
void check_host_lives(const burin_host* host, const burin_host& then);

}  // namespace burin_probe
