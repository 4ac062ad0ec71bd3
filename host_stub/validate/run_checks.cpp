// Runs checks in this process or in children, and passes their verdicts on in the order of the checks.
#include "validate/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// The topic of a check, "life" of "life.begin-default".
std::string_view topic_of(const Result& result) {
  const std::string_view name = result.check->name;
  return name.substr(0, name.find('.'));
}

/// Checks that compare two drawings which should be the same, besides those of `shape` and `repeat`.
bool compares(const Result& result) {
  constexpr std::array<std::string_view, 11> names = {
      "life.many-strokes",       "life.two-brushes",     "host.newer",           "host.older",
      "host.older-batch",        "evaluate.batch-sizes", "evaluate.stride-zero", "evaluate.wide-strides",
      "evaluate.output-strides", "process.lent",         "ability.end-influence"};
  const std::string_view topic = topic_of(result);
  return topic == "shape" || topic == "repeat" || std::ranges::find(names, result.check->name) != names.end();
}

/// Whether a check draws strokes, and could crash with others.
bool draws(const Result& result) {
  const std::string_view topic = topic_of(result);
  return topic != "module" && topic != "descriptor" && topic != "memory";
}

/// A fault that makes other checks fail, which then tell nothing new and are skipped.
struct Cause {
  std::string_view check;
  std::string_view told;  ///< a part of what it tells then
  const char* text;
  bool (*explains)(const Result& failure);
};

/// A brush that cannot draw with its defaults fails in each check that draws, and only those of memory may
/// tell why. One without room for large batches crashes wherever there are some, and one that draws otherwise
/// each time fails wherever drawings are compared.
constexpr std::array<Cause, 3> causes = {
    {{"life.begin-default", "", "a brush does not draw with its defaults, see life.begin-default", draws},
     {"evaluate.batch-sizes", "crashes with a batch of",
      "a brush crashes with some sizes of batches, see evaluate.batch-sizes",
      [](const Result& failure) {
        const bool crashed =
            failure.verdict == Verdict::crash || failure.text.find("process crashes") != failure.text.npos;
        return draws(failure) && crashed;
      }},
     {"repeat.runs", "", "a brush draws otherwise each time, see repeat.runs",
      [](const Result& failure) { return failure.verdict == Verdict::fail && compares(failure); }}}};

bool is_there(const Cause& cause, const Result& result) {
  return result.check->name == cause.check && has_failed(result) &&
         result.text.find(cause.told) != result.text.npos;
}

void skip_what_follows(std::vector<Result>& results) {
  for (const Cause& cause : causes) {
    if (std::ranges::none_of(results, [&](const Result& result) { return is_there(cause, result); }))
      continue;
    for (Result& result : results) {
      if (!has_failed(result) || result.check->name == cause.check || !cause.explains(result)) continue;
      result.verdict = Verdict::skip;
      result.text = cause.text;
    }
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
