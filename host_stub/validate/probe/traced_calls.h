#pragma once
#include <burin/abi/plugin.h>

#include <functional>
#include <string>
#include <vector>

namespace burin::validate {

/// The functions of memory, locks and files that the module itself calls during `work`, each once, with the
/// places in the module's file that the first call came from: "malloc 2 times, first at 0x1234 < 0x1400". The
/// module's table of addresses is changed for that time; calls by libraries on its behalf are not seen.
std::vector<std::string> calls_during(const burin_plugin_entry& entry, const std::function<void()>& work);

/// Runs `work` while the system lets this process neither open files, nor write, nor connect, nor start
/// others: such a call ends the process by SIGSYS. It stays so.
void without_system_calls(const std::function<void()>& work);

}  // namespace burin::validate
