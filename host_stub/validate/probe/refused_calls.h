#pragma once
#include <functional>
#include <string>

namespace burin::validate {

/// Runs `work` in a copy of this process that the system lets neither open, read nor write files, nor sleep,
/// connect, or start threads or processes. Returns the first such call and the places in the file of the
/// module that holds `address` that it came from, "openat at 0x1234"; empty if there was none. Throws Skipped
/// where systems do not refuse calls, and Failed if the process crashes.
std::string refused_call(const void* address, const std::function<void()>& work);

}  // namespace burin::validate
