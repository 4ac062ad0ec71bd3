// Times evaluate of many brushes in turn, so that what else the machine does meets all alike.
#include "bench_brush/brush_times.h"

#include <burin/abi/ext/bench_budget.h>
#include <burin/host/plugin/search_path.h>

#include <algorithm>
#include <memory>

#include "validate/checks/timing.h"
#include "validate/work_folder.h"

namespace burin {
namespace {

constexpr std::size_t batch = 4096;  ///< nodes
constexpr int tries = 3;             ///< of a round, of which the fastest counts

/// A stroke of a brush that is about to be measured.
class Candidate {
 public:
  Candidate(std::shared_ptr<const validate::Plugin> plugin, const burin_brush_descriptor& descriptor,
            const validate::Subject& subject, BrushOrigin origin)
      : plugin_(std::move(plugin)), brush_(*plugin_, descriptor, subject), stroke_(brush_) {
    times_.id = descriptor.id;
    times_.origin = origin;
    if (const auto* budget = brush_.interface<burin_bench_budget>(BURIN_EXT_BENCH_BUDGET))
      times_.budget = budget->evaluate_cost(&brush_.abi(), &stroke_.params());
    stroke_.evaluate(validate::random_nodes(batch, 1));  // What it cannot evaluate it tells here.
  }

  void measure(const validate::Nodes& nodes) {
    const double time = evaluate_time(stroke_, nodes, tries);
    times_.nanoseconds.push_back(time);
    times_.multiples.push_back(time / copy_time(brush_.descriptor, nodes, tries));
  }

  BrushTimes& times() { return times_; }

 private:
  std::shared_ptr<const validate::Plugin> plugin_;
  validate::ProbeBrush brush_;
  validate::ProbeStroke stroke_;
  BrushTimes times_;
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

void add_stock(const validate::WorkFolder& folder, const std::filesystem::path& brushes,
               Candidates& candidates) {
  for (const std::filesystem::path& module : plugin_files(brushes)) {
    try {
      add_brushes(folder.subject(module, 1), BrushOrigin::stock, candidates);
    } catch (const Error&) {
      // It needs a file of its user.
    }
  }
}

}  // namespace

std::vector<BrushTimes> measure_brushes(const BrushModules& modules, int rounds) {
  const validate::WorkFolder folder;
  Candidates candidates;
  add_brushes(folder.subject(modules.plugin, 1), BrushOrigin::plugin, candidates);
  if (!modules.other.empty()) add_brushes(folder.subject(modules.other, 1), BrushOrigin::other, candidates);
  add_stock(folder, modules.stock, candidates);
  const validate::Nodes nodes = validate::random_nodes(batch, 1);
  // To and fro, so that none is always measured after the same one.
  for (int round = 0; round < rounds; ++round) {
    for (const auto& candidate : candidates) candidate->measure(nodes);
    std::ranges::reverse(candidates);
  }
  if (rounds % 2 != 0) std::ranges::reverse(candidates);
  std::vector<BrushTimes> times;
  for (const auto& candidate : candidates) times.push_back(std::move(candidate->times()));
  return times;
}

Estimate ratio_of(const BrushTimes& one, const BrushTimes& other) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < one.nanoseconds.size(); ++round)
    ratios.push_back(one.nanoseconds[round] / other.nanoseconds[round]);
  return bootstrap_mean_ratio(ratios);
}

Estimate multiple_of(const BrushTimes& brush) { return bootstrap_mean_ratio(brush.multiples); }

}  // namespace burin
