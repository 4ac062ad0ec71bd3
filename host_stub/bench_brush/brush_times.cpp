// Times evaluate of many brushes in turn, so that what else the machine does meets all alike. Where code and
// data come to lie in memory decides about the speed of a short evaluate, and stays the same within a process
// [Curtsinger and Berger, "Stabilizer: Statistically Sound Performance Evaluation", ASPLOS 2013]. So there
// are several processes, which load the modules in random order at random places, and intervals count
// processes.
#include "bench_brush/brush_times.h"

#include <burin/abi/ext/bench_budget.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/host/plugin/search_path.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "report/report_folder.h"
#include "system/child_tasks.h"
#include "system/console.h"
#include "validate/checks/timing.h"
#include "validate/work_folder.h"

namespace burin {
namespace {

constexpr std::size_t batch = 4096;  ///< nodes
constexpr int tries = 3;             ///< of a round, of which the fastest counts
constexpr double longest = 600;      ///< seconds that a process may take

/// A stroke of a brush that is about to be measured.
class Candidate {
 public:
  Candidate(std::shared_ptr<const validate::Plugin> plugin, const burin_brush_descriptor& descriptor,
            const validate::Subject& subject, BrushOrigin origin)
      : plugin_(std::move(plugin)), brush_(*plugin_, descriptor, subject), stroke_(brush_) {
    times_.id = descriptor.id;
    times_.origin = origin;
    times_.nanoseconds = times_.multiples = {std::numeric_limits<double>::infinity()};
    if (const auto* budget = brush_.interface<burin_bench_budget>(BURIN_EXT_BENCH_BUDGET))
      times_.budget = budget->evaluate_cost(&brush_.abi(), &stroke_.params());
    stroke_.evaluate(validate::random_nodes(batch, 1));  // What it cannot evaluate it tells here.
  }

  void measure(const validate::Nodes& nodes) {
    const double time = evaluate_time(stroke_, nodes, tries);
    copy_time_ = std::min(copy_time_, copy_time(brush_.descriptor, nodes, tries));
    times_.nanoseconds[0] = std::min(times_.nanoseconds[0], time);
    times_.multiples[0] = times_.nanoseconds[0] / copy_time_;
  }

  /// Of this process.
  const BrushTimes& times() const { return times_; }

 private:
  std::shared_ptr<const validate::Plugin> plugin_;
  validate::ProbeBrush brush_;
  validate::ProbeStroke stroke_;
  BrushTimes times_;
  double copy_time_ = std::numeric_limits<double>::infinity();  ///< nanoseconds a node
};

using Candidates = std::vector<std::unique_ptr<Candidate>>;

void add_brushes(const validate::Subject& subject, BrushOrigin origin, Candidates& candidates) {
  const auto plugin = std::make_shared<const validate::Plugin>(subject);
  for (const burin_brush_descriptor* descriptor : plugin->brushes()) {
    const bool only_solids = descriptor->outputs_written == 0;
    if (only_solids && origin == BrushOrigin::stock) continue;
    candidates.push_back(std::make_unique<Candidate>(plugin, *descriptor, subject, origin));
  }
}

struct Source {
  std::filesystem::path module;
  BrushOrigin origin;
};

/// The modules in an order of this process's own.
std::vector<Source> shuffled_sources(const BrushModules& modules, std::mt19937_64& random) {
  std::vector<Source> sources = {{modules.plugin, BrushOrigin::plugin}};
  if (!modules.other.empty()) sources.push_back({modules.other, BrushOrigin::other});
  for (const std::filesystem::path& module : plugin_files(modules.stock))
    sources.push_back({module, BrushOrigin::stock});
  std::shuffle(sources.begin(), sources.end(), random);
  return sources;
}

void add_source(const Source& source, const validate::WorkFolder& folder, Candidates& candidates) {
  try {
    add_brushes(folder.subject(source.module, 1), source.origin, candidates);
  } catch (const Error&) {
    // A stock brush that needs a file of its user.
    if (source.origin != BrushOrigin::stock) throw;
  }
}

/// Measures all brushes in this process, whose number decides what lies where.
std::vector<BrushTimes> measure_here(const BrushModules& modules, const validate::WorkFolder& folder,
                                     int rounds, std::size_t process) {
  std::mt19937_64 random(process);
  Candidates candidates;
  std::vector<std::vector<char>> gaps;
  for (const Source& source : shuffled_sources(modules, random)) {
    gaps.emplace_back(random() % 65536);
    add_source(source, folder, candidates);
  }
  const validate::Nodes nodes = validate::random_nodes(batch, 1);
  // To and fro, so that none is always measured after the same one.
  for (int round = 0; round < rounds; ++round) {
    for (const auto& candidate : candidates) candidate->measure(nodes);
    std::ranges::reverse(candidates);
  }
  if (rounds % 2 != 0) std::ranges::reverse(candidates);
  std::vector<BrushTimes> times;
  for (const auto& candidate : candidates) times.push_back(candidate->times());
  return times;
}

std::string text_of(const std::vector<BrushTimes>& times) {
  Json json = Json::array();
  for (const BrushTimes& brush : times)
    json.push_back({{"id", brush.id},
                    {"origin", static_cast<int>(brush.origin)},
                    {"budget", brush.budget},
                    {"nanoseconds", brush.nanoseconds[0]},
                    {"multiple", brush.multiples[0]}});
  return json.dump();
}

/// Adds what a process measured.
void add_times(const std::filesystem::path& file, std::vector<BrushTimes>& times) {
  for (const Json& one : Json::parse(read_file(file))) {
    const auto origin = static_cast<BrushOrigin>(one["origin"].get<int>());
    auto brush = std::ranges::find_if(
        times, [&](const BrushTimes& known) { return known.origin == origin && known.id == one["id"]; });
    if (brush == times.end()) brush = times.insert(times.end(), {one["id"], origin, one["budget"], {}, {}});
    brush->nanoseconds.push_back(one["nanoseconds"]);
    brush->multiples.push_back(one["multiple"]);
  }
}

}  // namespace

std::vector<BrushTimes> measure_brushes(const BrushModules& modules, int rounds) {
  const validate::WorkFolder folder;
  const std::filesystem::path results = folder.subject(modules.plugin, 1).folder;
  const auto file_of = [&](std::size_t process) { return results / fmt::format("{}.json", process); };
  const auto children = run_in_children(measuring_processes, 1, longest, [&](std::size_t process) {
    try {
      write_text(file_of(process), text_of(measure_here(modules, folder, rounds, process)));
      return std::string();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  });
  std::vector<BrushTimes> times;
  for (std::size_t process = 0; process < children.size(); ++process) {
    if (!children[process].text.empty()) throw FileError(modules.plugin.string(), children[process].text);
    add_times(file_of(process), times);
  }
  // A stock brush that some processes could not load has no interval.
  std::erase_if(times,
                [](const BrushTimes& brush) { return brush.nanoseconds.size() != measuring_processes; });
  return times;
}

Estimate mean_ratio(const std::vector<double>& ratios) {
  // The 0.975 quantile of Student's distribution with nine degrees of freedom.
  static_assert(measuring_processes == 10);
  constexpr double quantile = 2.262;
  const auto count = static_cast<double>(ratios.size());
  double sum = 0, squares = 0;
  for (const double ratio : ratios) sum += std::log(ratio);
  const double mean = sum / count;
  for (const double ratio : ratios) squares += (std::log(ratio) - mean) * (std::log(ratio) - mean);
  const double half = quantile * std::sqrt(squares / (count - 1) / count);
  return {std::exp(mean - half), std::exp(mean), std::exp(mean + half)};
}

Estimate ratio_of(const BrushTimes& one, const BrushTimes& other) {
  std::vector<double> ratios;
  for (std::size_t process = 0; process < one.nanoseconds.size(); ++process)
    ratios.push_back(one.nanoseconds[process] / other.nanoseconds[process]);
  return mean_ratio(ratios);
}

Estimate multiple_of(const BrushTimes& brush) { return mean_ratio(brush.multiples); }

}  // namespace burin
