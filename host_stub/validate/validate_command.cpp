// The command `burin validate`: tests whether a plugin keeps to the ABI.
#include <burin/base/file.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "command.h"
#include "fuzz/fuzz.h"
#include "options/options.h"
#include "report/report_folder.h"
#include "system/console.h"
#include "validate/badge.h"
#include "validate/child_checks.h"
#include "validate/report.h"
#include "validate/work_folder.h"

namespace burin::command {
namespace {

using namespace validate;

struct ValidateOptions {
  std::string module, junit, badge, explain;
  std::vector<std::string> only, params;
  int level = levels - 1;
  std::uint64_t seed = 1;
  RunOptions run;
  double fuzz_minutes = 0;  ///< 0: checks instead
  double fuzz_time_limit = FuzzOptions().time_limit;
  std::string bundle;
  bool json = false, list = false, quiet = false;
};

const Check& named_check(const std::string& name) {
  if (const Check* check = find_check(name)) return *check;
  throw Error(fmt::format("no check {}; --list lists them", quoted_word(name)));
}

void print_list() {
  for (const Check& check : all_checks())
    write_result(fmt::format("{}  {:<32} {}\n", check.level, check.name, check.what));
}

void print_explanation(const Check& check) {
  write_result(fmt::format("{}, level {}\n  {}\n  {}\n", check.name, check.level, check.what, check.clause));
}

std::vector<const Check*> chosen_checks(const ValidateOptions& options) {
  std::set<const Check*> named;
  for (const std::string& name : options.only) named.insert(&named_check(name));
  std::vector<const Check*> chosen;
  for (const Check& check : all_checks())
    if (named.empty() ? check.level <= options.level : named.contains(&check)) chosen.push_back(&check);
  return chosen;
}

void validate_module(const ValidateOptions& options) {
  for (const std::string& file : {options.junit, options.badge})
    if (!file.empty()) check_output(file);
  if (!std::filesystem::is_regular_file(options.module)) throw FileError(options.module, "is no file");
  const WorkFolder folder;
  folder.add_solid();
  Subject subject = folder.subject(options.module, options.seed);
  for (const auto& [name, value] : parse_param_settings(options.params, [](auto&) { return true; }))
    subject.params[name] = std::get<std::string>(value);
  check_params(subject);
  keep_plugins_off_standard_output();
  const std::vector<Result> results = run_checks(subject, chosen_checks(options), options.run);
  const Counts counts = count(results);
  // A level is that of all its checks.
  const int highest = options.only.empty() ? options.level : 0;
  write_result(options.json    ? json_text(json_report(subject, results, highest))
               : options.quiet ? short_report(subject, results)
                               : text_report(subject, results));
  if (!options.junit.empty()) write_text(options.junit, junit_report(subject, results));
  if (!options.badge.empty())
    write_text(options.badge, badge_text(subject.module, level_reached(results, options.level)));
  if (counts.failed == 0 && counts.passed > 0) return;
  flush_results();
  throw std::runtime_error(
      counts.failed ? fmt::format("{}: {} of {} checks failed", options.module, counts.failed, results.size())
                    : fmt::format("{}: nothing was tested", options.module));
}

/// Where a failure goes unless the user says so: NAME.failure in the working directory.
std::filesystem::path bundle_of(const ValidateOptions& options) {
  if (!options.bundle.empty()) return options.bundle;
  return std::filesystem::path(options.module).filename().replace_extension(".failure");
}

void fuzz_module(const ValidateOptions& options) {
  if (!std::filesystem::is_regular_file(options.module)) throw FileError(options.module, "is no file");
  const std::filesystem::path bundle = bundle_of(options);
  check_report_folder(bundle.string());
  const WorkFolder folder;
  folder.add_solid();
  const FuzzResult result = fuzz(folder.subject(options.module, options.seed),
                                 {options.fuzz_minutes, options.run.jobs, options.fuzz_time_limit, bundle});
  if (!result.failure.empty()) {
    write_result(
        fmt::format("FAIL    {}\n        burin replay {}\n", result.failure, shell_word(bundle.string())));
    flush_results();
    throw std::runtime_error(fmt::format("{}: one of {} trials failed", options.module, result.trials));
  }
  write_result(fmt::format("{} trials, none failed, {} refused{}{}\n", result.trials, result.refused,
                           result.refusal.empty() ? "" : ", the last since ", result.refusal));
  if (result.refused < result.trials) return;
  flush_results();
  throw std::runtime_error(fmt::format("{}: nothing was tested", options.module));
}

void run(const ValidateOptions& options) {
  if (options.list) return print_list();
  if (!options.explain.empty()) return print_explanation(named_check(options.explain));
  if (options.module.empty()) throw CLI::ValidationError("plugin", "a plugin is required");
  if (!options.badge.empty() && !options.only.empty())
    throw CLI::ValidationError("--write-badge", "a badge needs all checks of a level, not --only");
  if (options.fuzz_minutes > 0) return fuzz_module(options);
  validate_module(options);
}

}  // namespace

void add_validate(CLI::App& app) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App& command = *app.add_subcommand("validate", "test whether a plugin keeps to the plugin ABI");
  command.add_option("plugin", options->module, "module to test, NAME.burin")->type_name("FILE");
  CLI::Option* level =
      command
          .add_option("--level", options->level,
                      "test this level and those below: 1 loads and behaves, 2 the contract, 3 robust, 4 "
                      "deterministic and "
                      "bounded (the default), 5 fast, for machines that are not busy")
          ->check(CLI::Range(1, levels));
  CLI::Option* only =
      command
          .add_option("--only", options->only,
                      "run this check; several are separated by commas, or --only is repeated")
          ->type_name("CHECK")
          ->delimiter(',')
          ->allow_extra_args(false);
  command.add_option("--seed", options->seed, "seed of what is random, 1 unless given")
      ->check(whole_number_from_0());
  command.add_option("--jobs", options->run.jobs, "checks at a time, 2 unless given")
      ->check(CLI::Range(1, 64));
  CLI::Option* in_process =
      command.add_flag("--in-process", options->run.in_process, "run checks in this process, for a debugger");
  CLI::Option* params = command
                            .add_option("--param", options->params,
                                        "value of a parameter instead of its default, for all checks; may be "
                                        "given repeatedly")
                            ->type_name("NAME=VALUE")
                            ->allow_extra_args(false);
  CLI::Option* quiet =
      command.add_flag("--quiet", options->quiet, "print the first failures and the last line only");
  CLI::Option* json = command.add_flag("--json", options->json, "write JSON to the standard output");
  CLI::Option* junit =
      command.add_option("--junit", options->junit, "JUnit file to write")->type_name("FILE");
  CLI::Option* badge = command
                           .add_option("--write-badge", options->badge,
                                       "badge to write; `burin list` shows NAME.badge.json beside NAME.burin")
                           ->type_name("FILE");
  CLI::Option* fuzz =
      command
          .add_option(
              "--fuzz", options->fuzz_minutes,
              "instead of checks, draw random strokes on random surfaces with random parameters for so "
              "many minutes, or until one fails")
          ->type_name("MINUTES")
          ->check(positive_number());
  for (CLI::Option* of_checks : {level, only, in_process, params, quiet, json, junit, badge})
    fuzz->excludes(of_checks);
  command
      .add_option("--bundle", options->bundle,
                  "folder for the stroke, surface and parameters that failed, for `burin replay`; "
                  "NAME.failure unless given")
      ->type_name("FOLDER")
      ->needs(fuzz);
  command
      .add_option("--time-limit", options->fuzz_time_limit,
                  "seconds after which a random stroke hangs, 30 unless given")
      ->type_name("SECONDS")
      ->check(positive_number())
      ->needs(fuzz);
  command.add_flag("--list", options->list, "list the checks");
  command.add_option("--explain", options->explain, "tell what a check does, and which clause it tests")
      ->type_name("CHECK");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
