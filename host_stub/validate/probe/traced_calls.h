#pragma once
#include <burin/abi/plugin.h>

#include <functional>
#include <string>
#include <vector>

namespace burin::validate {

/// The functions of memory, locks and files that the module calls during `work`, itself or by a library as
/// that of C++, each once, with the places in the module's file that the first call came from: "malloc 2
/// times, first at 0x1234 < 0x1400". Tables of addresses are changed for that time. What the host's services
/// call is not counted.
std::vector<std::string> calls_during(const burin_plugin_entry& entry, const std::function<void()>& work);

/// Throws Skipped if another library than that of C serves malloc, as with sanitizers: then calls of it do
/// not pass through the tables that are changed, and the heap of the C library stays empty.
void require_countable_memory();

}  // namespace burin::validate
