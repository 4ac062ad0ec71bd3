// The command `burin bench`: runs the cases of a suite and prints or reports their figures, compares them
// with a baseline, or compares this build with another one.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/text/quoted_word.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/against.h"
#include "bench/baseline.h"
#include "bench/regression.h"
#include "bench/report.h"
#include "bench/result_text.h"
#include "bench/run_case.h"
#include "bench/run_suite.h"
#include "command.h"
#include "input/brush_folder.h"
#include "options/options.h"
#include "report/report_folder.h"
#include "system/output_file.h"

namespace burin::command {
namespace {

struct BenchOptions {
  std::string suite;
  std::vector<std::string> cases, history;
  std::optional<std::size_t> repeat;
  std::string report, picture, baseline, write_baseline;
  AgainstOptions against;
  bool json = false;
};

/// The suite with the cases that the options select, or with all.
Suite chosen_suite(const BenchOptions& options) {
  Suite suite = read_suite(options.suite);
  if (options.cases.empty()) return suite;
  std::vector<BenchCase> chosen;
  for (const std::string& name : options.cases) {
    const auto found = std::find_if(suite.cases.begin(), suite.cases.end(),
                                    [&](const BenchCase& one) { return one.name == name; });
    if (found == suite.cases.end())
      throw FileError(suite.path, fmt::format("has no case {}", quoted_word(name)));
    chosen.push_back(*found);
  }
  suite.cases = std::move(chosen);
  return suite;
}

/// The folder for the pictures of a report; empty without a report.
std::filesystem::path picture_folder(const BenchOptions& options) {
  return options.report.empty() ? std::filesystem::path()
                                : std::filesystem::path(options.report) / "pictures";
}

SuiteResult run_here(const Suite& suite, const BenchOptions& options) {
  BrushLibrary brushes(log_on_console, stamp_services(read_vdb));
  load_brushes(brushes);
  const BenchCase& one = suite.cases[0];
  ProgressBar bar;
  const std::size_t repeat = options.repeat.value_or(one.repeat);
  const std::filesystem::path picture = options.picture.empty() ? picture_file(picture_folder(options), 1)
                                                                : std::filesystem::path(options.picture);
  return {suite.name, {run_case(suite.path, one, repeat, picture, brushes, bar.progress())}};
}

/// Measures the suite. A single case runs in this process, which run_case_in_process() relies on.
SuiteResult measure(const Suite& suite, const BenchOptions& options) {
  if (options.cases.size() == 1) return run_here(suite, options);
  ProgressBar bar;
  return run_suite(suite, options.repeat, picture_folder(options), bar.progress());
}

void print(const SuiteResult& result, bool json) {
  const std::vector<Scaling> growth = scalings(result);
  if (!json) {
    write_result(result_text(result, growth));
    return;
  }
  Json all = result_json(result);
  all["scaling"] = scalings_json(growth);
  write_result(json_text(all));
}

std::vector<NamedResult> read_history(const std::vector<std::string>& files) {
  std::vector<NamedResult> results;
  results.reserve(files.size());
  for (const std::string& file : files) results.push_back({file, read_result(JsonValue::read(file))});
  return results;
}

void check_baseline(const JsonValue& baseline, const std::string& path, const SuiteResult& result) {
  const std::vector<std::string> lines = differences(baseline, result);
  for (const std::string& line : lines) log_on_console(0, line);
  if (!lines.empty()) throw Regression(fmt::format("{}: {} differences", path, lines.size()));
}

void run_measurement(const BenchOptions& options) {
  std::vector<NamedResult> results = read_history(options.history);
  std::optional<JsonValue> baseline;
  if (!options.baseline.empty()) baseline = JsonValue::read(options.baseline);
  if (!options.suite.empty()) {
    SuiteResult result = measure(chosen_suite(options), options);
    print(result, options.json);
    if (!options.write_baseline.empty()) write_text(options.write_baseline, json_text(baseline_json(result)));
    results.push_back({"this run", std::move(result)});
  }
  if (!options.report.empty()) write_bench_report(options.report, results);
  if (baseline) check_baseline(*baseline, options.baseline, results.back().result);
}

void run_against(BenchOptions options) {
  options.against.repeat = options.repeat;
  const Suite suite = chosen_suite(options);
  const std::vector<Comparison> comparisons = [&] {
    ProgressBar bar;
    return compare_builds(suite, options.against, bar.progress());
  }();
  if (options.json)
    write_result(json_text(against_json(suite, options.against, comparisons)));
  else
    write_result(against_text(options.against, comparisons));
  check_comparisons(options.against, comparisons);
}

void run(const BenchOptions& options) {
  if (options.suite.empty() && (options.history.empty() || options.report.empty()))
    throw CLI::ValidationError("bench", "takes a suite, or --history with --report");
  if (!options.picture.empty() && options.cases.size() != 1)
    throw CLI::ValidationError("--picture", "is of one --case");
  check_report_folder(options.report);
  check_output_path(options.write_baseline);
  if (options.against.other.empty())
    run_measurement(options);
  else
    run_against(options);
}

}  // namespace

void add_bench(CLI::App& app) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *app.add_subcommand("bench", "measure a suite of replays, compare builds and results");
  CLI::Option* suite =
      command.add_option("suite", options->suite, "what to measure")->type_name("SUITE.json");
  command.add_option("--case", options->cases, "only the case of this name, repeatable")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->needs(suite);
  command.add_option("--repeat", options->repeat, "times that strokes are drawn, instead of the suite's")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000}));
  CLI::Option* baseline = command
                              .add_option("--baseline", options->baseline,
                                          "fail where hashes or counters are not those of a file")
                              ->type_name("FILE")
                              ->needs(suite);
  CLI::Option* write =
      command.add_option("--write-baseline", options->write_baseline, "write hashes and counters to a file")
          ->type_name("FILE")
          ->needs(suite);
  CLI::Option* report =
      command.add_option("--report", options->report, "folder for index.html and result.json")
          ->type_name("FOLDER");
  CLI::Option* picture =
      command
          .add_option("--picture", options->picture, "picture to draw of the case's result, with one --case")
          ->type_name("FILE.png")
          ->needs(suite);
  CLI::Option* history =
      command.add_option("--history", options->history, "earlier results, oldest first, for the report")
          ->type_name("RESULT.json")
          ->needs(report);
  CLI::Option* against = command
                             .add_option("--against", options->against.other,
                                         "another build's burin, to run in turn with this one")
                             ->type_name("BURIN")
                             ->check(CLI::ExistingFile)
                             ->needs(suite);
  for (CLI::Option* other : {baseline, write, report, picture, history}) against->excludes(other);
  command.add_option("--rounds", options->against.rounds, "runs of each build")
      ->check(CLI::Range(std::size_t{2}, std::size_t{1000}))
      ->capture_default_str()
      ->needs(against);
  command
      .add_option("--threshold", options->against.threshold,
                  "fail above this ratio of this build to the other")
      ->check(positive_number())
      ->capture_default_str()
      ->needs(against);
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
