// Compares two builds. They run alternately, each in its own process, so that slow changes of the machine's
// speed affect both alike; the ratio of their times is estimated by a bootstrap over the rounds.
#include "bench/against.h"

#include <burin/base/program_file.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bench/regression.h"
#include "bench/run_suite.h"

namespace burin {
namespace {

/// The mean time of all events and ends of a case, in which a slower end of a stroke shows too.
double mean_stroke_ms(const CaseResult& result) {
  const std::vector<double>& seconds = result.stroke_seconds;
  return 1e3 * std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
}

/// Runs a build once and appends its time. The hash must be the same in every round.
void run_round(const std::filesystem::path& burin, const Suite& suite, const std::string& name,
               std::size_t repeat, std::vector<double>& times, std::string& hash) {
  const CaseResult result = run_case_in_process(burin, suite, name, repeat);
  if (!times.empty() && result.hash != hash)
    throw Regression(fmt::format("{}: case {} gave another result than a round before", burin.string(),
                                 quoted_word(name)));
  times.push_back(mean_stroke_ms(result));
  hash = result.hash;
}

Comparison compare(const Suite& suite, const std::string& name, const AgainstOptions& options,
                   const Progress& progress, std::size_t rounds_before) {
  const auto all_rounds = static_cast<double>(options.rounds * suite.cases.size());
  Comparison comparison;
  comparison.name = name;
  std::vector<double> ratios;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    report(progress, name, static_cast<double>(rounds_before + round) / all_rounds);
    // Rounds are the repetition, so each runs the strokes once unless more repeats are requested.
    const std::size_t repeat = options.repeat.value_or(1);
    run_round(program_file(), suite, name, repeat, comparison.this_ms, comparison.this_hash);
    run_round(options.other, suite, name, repeat, comparison.other_ms, comparison.other_hash);
    ratios.push_back(comparison.this_ms.back() / comparison.other_ms.back());
  }
  comparison.ratio = bootstrap_mean_ratio(ratios);
  return comparison;
}

std::string verdict(const Comparison& comparison, double threshold) {
  if (comparison.differs()) return "another result";
  if (comparison.slower(threshold)) return "slower";
  return "ok";
}

}  // namespace

std::vector<Comparison> compare_builds(const Suite& suite, const AgainstOptions& options,
                                       const Progress& progress) {
  std::vector<Comparison> comparisons;
  for (const BenchCase& one : suite.cases)
    comparisons.push_back(compare(suite, one.name, options, progress, comparisons.size() * options.rounds));
  return comparisons;
}

Json against_json(const Suite& suite, const AgainstOptions& options,
                  const std::vector<Comparison>& comparisons) {
  Json cases = Json::array();
  for (const Comparison& one : comparisons) {
    cases.push_back({{"name", one.name},
                     {"ratio", one.ratio.value},
                     {"low", one.ratio.low},
                     {"high", one.ratio.high},
                     {"this_ms", one.this_ms},
                     {"other_ms", one.other_ms},
                     {"this_hash", one.this_hash},
                     {"other_hash", one.other_hash},
                     {"verdict", verdict(one, options.threshold)}});
  }
  return {{"burin_bench_against", 1},
          {"suite", suite.name},
          {"this", program_file().string()},
          {"other", options.other.string()},
          {"rounds", options.rounds},
          {"threshold", options.threshold},
          {"cases", cases}};
}

std::string against_text(const AgainstOptions& options, const std::vector<Comparison>& comparisons) {
  std::string text = fmt::format("{:<28} {:>7}  {:<16} {}\n", "this / other", "ratio", "95 % interval", "");
  for (const Comparison& one : comparisons) {
    text += fmt::format("{:<28} {:7.3f}  {:.3f} .. {:.3f}   {}\n", one.name, one.ratio.value, one.ratio.low,
                        one.ratio.high, verdict(one, options.threshold));
  }
  return text;
}

void check_comparisons(const AgainstOptions& options, const std::vector<Comparison>& comparisons) {
  const auto bad = std::count_if(comparisons.begin(), comparisons.end(), [&](const Comparison& one) {
    return one.differs() || one.slower(options.threshold);
  });
  if (bad == 0) return;
  throw Regression(
      fmt::format("{} of {} cases {} slower than {:g} times the other build or have another result", bad,
                  comparisons.size(), bad == 1 ? "is" : "are", options.threshold));
}

}  // namespace burin
