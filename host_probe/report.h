#pragma once

namespace burin_probe {

/// Writes what the host did and which rules it broke to the file that the environment variable
/// BURIN_PROBE_REPORT names, if any.
void write_report();

}  // namespace burin_probe
