#pragma once
#include <span>
#include <string>
#include <vector>

#include "validate/probe/check.h"

namespace burin::validate {

enum class Verdict { pass, fail, crash, timeout, skip };

/// "PASS", "FAIL", "CRASH", "TIMEOUT" or "SKIP".
const char* name_of(Verdict verdict);

/// What came of a check.
struct Result {
  const Check* check;
  Verdict verdict;
  std::string text;    ///< why, one line; of one that passed what there is to tell, or nothing
  double seconds = 0;  ///< of wall-clock time
};

/// Whether a rule was broken.
bool has_failed(const Result& result);

/// How checks are run.
struct RunOptions {
  int jobs = 2;             ///< checks at a time, each in a process of its own
  bool in_process = false;  ///< in this process, one after the other, for debuggers
};

/// The time after which a check is ended, seconds.
inline constexpr double time_limit = 20;

/// Runs checks; results are in their order. If the module cannot be loaded all others are skipped; and if a
/// brush cannot draw with its defaults, or draws otherwise each time, those that fail for that reason.
std::vector<Result> run_checks(const Subject& subject, std::span<const Check* const> checks,
                               const RunOptions& options);

/// Runs a check in this process.
Result run_here(const Subject& subject, const Check& check);

}  // namespace burin::validate
