#pragma once
#include <functional>
#include <string>

namespace burin::validate {

/// What `work` returns in a process of its own, a copy of this one. Throws Failed if the process does not
/// come to its end, and Failed or Skipped, with its text, if `work` does.
std::string in_process(const std::function<std::string()>& work);

}  // namespace burin::validate
