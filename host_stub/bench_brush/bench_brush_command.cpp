// The command `burin bench-brush`: measures a plugin's brushes beside the stock brushes, and against another
// version of the plugin.
#include <burin/base/error.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/regression.h"
#include "bench_brush/brush_report.h"
#include "command.h"
#include "input/brush_folder.h"
#include "report/report_folder.h"
#include "validate/work_folder.h"

namespace burin::command {
namespace {

struct BenchBrushOptions {
  std::string plugin, other, report;
  int rounds = 3;
  bool json = false;
};

/// A stroke by a session, unless the brush cannot draw one with its defaults.
std::optional<DrawnStroke> stroke_of(const std::string& plugin, const std::string& brush) {
  const validate::WorkFolder folder;
  try {
    return draw_stroke(plugin, brush, folder.subject(plugin, 1).stamp);
  } catch (const Error& error) {
    warn(error.what());
    return std::nullopt;
  }
}

BrushReport report_of(const BrushTimes& brush, const std::vector<BrushTimes>& all,
                      const std::string& plugin) {
  BrushReport report{brush, stroke_of(plugin, brush.id), {}, {}};
  for (const BrushTimes& one : all) {
    if (one.origin == BrushOrigin::stock) report.stock.push_back({one.id, ratio_of(brush, one)});
    if (one.origin == BrushOrigin::other && one.id == brush.id) report.against = ratio_of(brush, one);
  }
  std::ranges::sort(report.stock, {}, [](const auto& compared) { return compared.ratio.value; });
  return report;
}

/// The other version must have a brush to compare; says which it has not.
void check_against(const std::string& other, const std::vector<BrushReport>& reports) {
  if (std::ranges::none_of(reports, [](const auto& report) { return report.against.has_value(); }))
    throw FileError(other, "has no brush of the same id that can be measured");
  for (const BrushReport& report : reports)
    if (!report.against) warn(fmt::format("{}: has no {} that can be measured", other, report.brush.id));
}

void check_budgets(const std::vector<BrushReport>& reports) {
  for (const BrushReport& report : reports)
    if (!report.keeps_budget())
      throw Regression(fmt::format("{} takes longer than its budget of {:.3g} copies", report.brush.id,
                                   report.brush.budget));
}

void run(const BenchBrushOptions& options) {
  check_report_folder(options.report);
  keep_plugins_off_standard_output();
  const std::vector<BrushTimes> all =
      measure_brushes({options.plugin, options.other, own_brush_folder()}, options.rounds);
  std::vector<BrushReport> reports;
  for (const BrushTimes& brush : all)
    if (brush.origin == BrushOrigin::plugin) reports.push_back(report_of(brush, all, options.plugin));
  if (!options.other.empty()) check_against(options.other, reports);
  if (!options.report.empty()) write_brush_page(options.report, reports);
  Json json = Json::array();
  for (const BrushReport& report : reports) {
    json.push_back(brush_json(report));
    if (!options.json) write_result(brush_text(report));
  }
  if (options.json) write_result(json_text(json));
  check_budgets(reports);
}

}  // namespace

void add_bench_brush(CLI::App& app) {
  const auto options = std::make_shared<BenchBrushOptions>();
  CLI::App& command =
      *app.add_subcommand("bench-brush", "measure a plugin's brushes beside the stock brushes");
  command.add_option("plugin", options->plugin, "module to measure, NAME.burin")
      ->required()
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  command.add_option("--against", options->other, "another version of the plugin, measured in turn with it")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  command
      .add_option("--rounds", options->rounds, "times that each brush is measured in each of 10 processes")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command.add_option("--report", options->report, "folder for a page with pictures")->type_name("FOLDER");
  command.add_flag("--json", options->json, "write JSON to the standard output");
  command.callback([options] { run(*options); });
}

}  // namespace burin::command
