#pragma once
#include <span>
#include <vector>
#include "validate/run_checks.h"

namespace burin::validate {

/// Runs each check in a copy of this process, `jobs` at a time. What a plugin prints is discarded.
std::vector<Result> run_checks_in_children(const Subject& subject, std::span<const Check* const> checks,
                                           int jobs);

/// Throws Error if the subject has values for parameters that no brush of the module has, or that they cannot
/// have. Says nothing of a module that cannot be loaded.
void check_params(const Subject& subject);

}  // namespace burin::validate
