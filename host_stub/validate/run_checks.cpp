// Runs checks in this process or in children, and passes their verdicts on in the order of the checks.
#include "validate/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "validate/child_checks.h"

namespace burin::validate {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "PASS";
    case Verdict::fail:
      return "FAIL";
    case Verdict::crash:
      return "CRASH";
    case Verdict::timeout:
      return "TIMEOUT";
    default:
      return "SKIP";
  }
}

Result run_here(const Subject& subject, const Check& check) {
  try {
    check.run(subject);
    return {&check, Verdict::pass, {}};
  } catch (const Told& told) {
    return {&check, Verdict::pass, told.what()};
  } catch (const Skipped& skipped) {
    return {&check, Verdict::skip, skipped.what()};
  } catch (const std::exception& error) {
    return {&check, Verdict::fail, error.what()};
  }
}

bool has_failed(const Result& result) {
  return result.verdict != Verdict::pass && result.verdict != Verdict::skip;
}

namespace {

/// Where a brush cannot draw with its defaults, each check that draws fails, and none tells why but those of
/// memory: the others are skipped.
void skip_what_follows(std::vector<Result>& results) {
  constexpr std::string_view cause = "life.begin-default";
  const bool draws = std::ranges::none_of(
      results, [](const Result& result) { return result.check->name == cause && has_failed(result); });
  if (draws) return;
  for (Result& result : results) {
    const std::string_view name = result.check->name, topic = name.substr(0, name.find('.'));
    if (!has_failed(result) || name == cause || topic == "module" || topic == "descriptor" ||
        topic == "memory")
      continue;
    result.verdict = Verdict::skip;
    result.text = "a brush does not draw with its defaults, see life.begin-default";
  }
}

}  // namespace

std::vector<Result> run_checks(const Subject& subject, std::span<const Check* const> checks,
                               const RunOptions& options) {
  const auto run = [&](std::span<const Check* const> some) {
    if (!options.in_process) return run_checks_in_children(subject, some, options.jobs);
    std::vector<Result> results;
    for (const Check* check : some) results.push_back(run_here(subject, *check));
    return results;
  };
  const Check* const loads = find_check("module.loads");
  const Result first = run({&loads, 1})[0];
  std::vector<const Check*> others;
  std::copy_if(checks.begin(), checks.end(), std::back_inserter(others),
               [&](const Check* check) { return check != loads; });
  std::vector<Result> results;
  if (others.size() < checks.size() || first.verdict != Verdict::pass) results.push_back(first);
  if (first.verdict == Verdict::pass) {
    const auto rest = run(others);
    results.insert(results.end(), rest.begin(), rest.end());
    skip_what_follows(results);
  } else {
    Result skipped{nullptr, Verdict::skip, "the module does not load"};
    for (const Check* check : others) {
      skipped.check = check;
      results.push_back(skipped);
    }
  }
  return results;
}

}  // namespace burin::validate
