#pragma once
#include <burin/base/progress.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/bootstrap.h"
#include "bench/suite.h"
#include "system/console.h"

namespace burin {

struct AgainstOptions {
  std::filesystem::path other;  ///< the other build's burin command
  std::size_t rounds = 5;       ///< of one run of each build
  std::optional<std::size_t> repeat;
  double threshold = 1.05;
};

/// One case by this build and the other.
struct Comparison {
  std::string name;
  std::vector<double> this_ms, other_ms;  ///< [round] mean time of the strokes, events and ends
  Estimate ratio;                         ///< of this build's times to the other's
  std::string this_hash, other_hash;

  bool differs() const { return this_hash != other_hash; }
  bool slower(double threshold) const { return ratio.low > threshold; }
};

/// Runs both builds in turn, this one first, round by round, each run in a process of its own. Throws as
/// run_case_in_process.
std::vector<Comparison> compare_builds(const Suite& suite, const AgainstOptions& options,
                                       const Progress& progress);

Json against_json(const Suite& suite, const AgainstOptions& options,
                  const std::vector<Comparison>& comparisons);
std::string against_text(const AgainstOptions& options, const std::vector<Comparison>& comparisons);

/// Throws Regression that counts the cases that are slower or have another result, if there are any.
void check_comparisons(const AgainstOptions& options, const std::vector<Comparison>& comparisons);

}  // namespace burin
