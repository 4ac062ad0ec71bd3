#pragma once
#include <span>
#include <vector>
#include "validate/run_checks.h"

namespace burin::validate {

/// Runs each check in a copy of this process, `jobs` at a time. What a plugin prints is discarded.
std::vector<Result> run_checks_in_children(const Subject& subject, std::span<const Check* const> checks,
                                           int jobs);

}  // namespace burin::validate
