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
  std::size_t rounds = 5;       ///< number of rounds; a round runs each build once
  std::optional<std::size_t> repeat;
  double threshold = 1.05;
};

/// One case, measured with this build and with the other.
struct Comparison {
  std::string name;
  std::vector<double> this_ms, other_ms;  ///< [round] mean time of the strokes' events and ends, ms
  Estimate ratio;                         ///< ratio of this build's times to the other's
  std::string this_hash, other_hash;

  bool differs() const { return this_hash != other_hash; }
  bool slower(double threshold) const { return ratio.low > threshold; }
};

/// Runs both builds alternately, this one first, round by round, each run in its own process. Throws as
/// run_case_in_process() does.
std::vector<Comparison> compare_builds(const Suite& suite, const AgainstOptions& options,
                                       const Progress& progress);

Json against_json(const Suite& suite, const AgainstOptions& options,
                  const std::vector<Comparison>& comparisons);
std::string against_text(const AgainstOptions& options, const std::vector<Comparison>& comparisons);

/// Throws Regression, with their number, if any cases are slower or have another result.
void check_comparisons(const AgainstOptions& options, const std::vector<Comparison>& comparisons);

}  // namespace burin
