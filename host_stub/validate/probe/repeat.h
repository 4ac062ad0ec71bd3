#pragma once
#include <functional>
#include <string>

#include "validate/probe/check.h"

namespace burin::validate {

/// A process ended without a word.
class Crashed : public Failed {
 public:
  using Failed::Failed;
};

/// What `work` returns in a process of its own, a copy of this one. Throws Crashed if the process does not
/// come to its end, and Failed or Skipped, with its text, if `work` does.
std::string in_process(const std::function<std::string()>& work);

}  // namespace burin::validate
