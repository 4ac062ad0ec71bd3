// Runs checks in this process or in children, and passes their verdicts on in the order of the checks.
#include "validate/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
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
  constexpr std::array<std::string_view, 13> names = {
      "life.many-strokes",     "life.two-brushes",        "host.newer",       "host.older",
      "host.older-batch",      "evaluate.batch-sizes",    "evaluate.varying", "evaluate.stride-zero",
      "evaluate.wide-strides", "evaluate.output-strides", "process.lent",     "ability.end-influence",
      "ability.end-distance"};
  const std::string_view topic = topic_of(result);
  return topic == "shape" || topic == "repeat" || std::ranges::find(names, result.check->name) != names.end();
}

/// Whether a check draws strokes, and could hang with others.
bool draws(const Result& result) {
  const std::string_view topic = topic_of(result);
  return (topic != "module" && topic != "descriptor") ||
         result.check->name == std::string_view("module.unloads");
}

/// Whether no stroke could begin in a check.
bool begins_nothing(const Result& result) {
  return draws(result) && result.text.find("begin fails") != result.text.npos;
}

/// Whether a check draws strokes and tells nothing of why a brush crashes.
bool only_draws(const Result& result) {
  return draws(result) && (topic_of(result) != "memory" || begins_nothing(result));
}

constexpr const char* draws_nothing = "a brush does not draw with its defaults, see life.begin-default";

/// Whether a check failed since it ended its process, or one that it started.
bool crashed(const Result& result) {
  return result.verdict == Verdict::crash || result.text.find("crashes") != result.text.npos;
}

/// A fault that makes other checks fail, which then tell nothing new and are skipped.
struct Cause {
  std::string_view check;
  bool (*is_there)(const Result& failure);  ///< of that check
  const char* text;
  bool (*explains)(const Result& failure);
};

bool always(const Result&) { return true; }

/// A table of parameters that cannot be read, or has one without a name for others to ask by, lets anything
/// fail. A brush may refuse a default that lies outside of its range. One that writes beyond its arrays does
/// so anywhere. One that cannot draw with its defaults fails in each check that draws, and only those of
/// memory may tell why. One without room for large batches crashes wherever there are some, and one that
/// draws otherwise each time fails wherever drawings are compared.
constexpr std::array<Cause, 6> causes = {
    {{"descriptor.param-ids",
      [](const Result& failure) {
        return crashed(failure) || failure.text.find("has no id") != failure.text.npos;
      },
      "its table of parameters cannot be read, see descriptor.param-ids", always},
     {"descriptor.param-defaults", always, "a default cannot be right, see descriptor.param-defaults",
      begins_nothing},
     {"memory.writes-within", always, "a brush writes beyond its arrays, see memory.writes-within", crashed},
     {"life.begin-default", always, draws_nothing, only_draws},
     {"evaluate.batch-sizes",
      [](const Result& failure) { return failure.text.find("crashes with a batch of") != failure.text.npos; },
      "a brush crashes with some sizes of batches, see evaluate.batch-sizes",
      [](const Result& failure) { return only_draws(failure) && crashed(failure); }},
     {"repeat.runs", always, "a brush draws otherwise each time, see repeat.runs",
      [](const Result& failure) { return failure.verdict == Verdict::fail && compares(failure); }}}};

bool is_there(const Cause& cause, const Result& result) {
  return result.check->name == cause.check && has_failed(result) && cause.is_there(result);
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

/// Runs checks, and keeps what each of them told.
class Run {
 public:
  Run(const Subject& subject, const RunOptions& options) : subject_(subject), options_(options) {}

  const Result& run(const Check* check) {
    run(std::vector{check});
    return done_.at(check);
  }

  /// Those that have not been run or skipped.
  void run(const std::vector<const Check*>& checks) {
    std::vector<const Check*> open;
    std::ranges::copy_if(checks, std::back_inserter(open),
                         [this](const Check* check) { return !done_.contains(check); });
    if (!options_.in_process) {
      for (const Result& result : run_checks_in_children(subject_, open, options_.jobs)) keep(result);
    } else {
      for (const Check* check : open) keep(run_here(subject_, *check));
    }
  }

  /// Skips checks that have not been run, if `explained` says that the reason is theirs.
  void skip(std::span<const Check* const> checks, const char* reason, bool (*explained)(const Result&)) {
    for (const Check* check : checks) {
      const Result skipped{check, Verdict::skip, reason};
      if (!done_.contains(check) && explained(skipped)) keep(skipped);
    }
  }

  const Result& of(const Check* check) const { return done_.at(check); }

 private:
  void keep(const Result& result) { done_.emplace(result.check, result); }

  const Subject& subject_;
  const RunOptions& options_;
  std::map<const Check*, Result> done_;
};

}  // namespace

std::vector<Result> run_checks(const Subject& subject, std::span<const Check* const> checks,
                               const RunOptions& options) {
  const Check *const loads = find_check("module.loads"), *const begins = find_check("life.begin-default");
  const auto is_asked = [&](const Check* check) { return std::ranges::find(checks, check) != checks.end(); };
  Run run(subject, options);
  const bool is_loaded = run.run(loads).verdict == Verdict::pass;
  if (!is_loaded) run.skip(checks, "the module does not load", [](const Result&) { return true; });
  // Each check would wait until its time is over.
  if (is_loaded && is_asked(begins) && run.run(begins).verdict == Verdict::timeout)
    run.skip(checks, draws_nothing, draws);
  run.run({checks.begin(), checks.end()});
  std::vector<Result> results;
  if (is_asked(loads) || !is_loaded) results.push_back(run.of(loads));
  for (const Check* check : checks)
    if (check != loads) results.push_back(run.of(check));
  skip_what_follows(results);
  return results;
}

}  // namespace burin::validate
