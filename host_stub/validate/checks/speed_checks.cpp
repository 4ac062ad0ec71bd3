// Checks times, which hold for a machine that is not busy.
#include <burin/abi/ext/bench_budget.h>
#include <fmt/format.h>

#include "validate/checks/timing.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

constexpr int runs = 15;  ///< of which the fastest counts

void check_budget(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const auto* budget = brush.interface<burin_bench_budget>(BURIN_EXT_BENCH_BUDGET);
    if (!budget) throw Skipped("it does not offer " BURIN_EXT_BENCH_BUDGET);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(4096, subject.seed);
    const double time = evaluate_time(stroke, nodes, runs), copy = copy_time(descriptor, nodes, runs);
    const double promised = budget->evaluate_cost(&brush.abi(), &stroke.params());
    require(time <= promised * copy,
            fmt::format("takes {:.1f} ns a node, {:.0f} times a copy, and promised {:.0f} times", time,
                        time / copy, promised));
  });
}

void check_growth_with_batch(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const Nodes small = random_nodes(1024, subject.seed), large = random_nodes(16384, subject.seed);
    const double few = evaluate_time(stroke, small, runs), many = evaluate_time(stroke, large, runs);
    require(
        many <= 4 * few + 20,
        fmt::format("takes {:.1f} ns a node in batches of 1024, {:.1f} ns in batches of 16384", few, many));
  });
}

void check_denormals(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const Nodes plain = random_nodes(1024, subject.seed);
    Nodes tiny = plain;
    for (std::size_t i = 0; i < tiny.size(); ++i) tiny.t(i) = tiny.d(i) = 1e-40f;
    const double normal = evaluate_time(stroke, plain, runs), denormal = evaluate_time(stroke, tiny, runs);
    require(denormal <= 20 * normal + 50,
            fmt::format("takes {:.1f} ns a node, {:.1f} ns where t and d are denormal", normal, denormal));
  });
}

constexpr Check speed_list[] = {
    {"speed.budget", 5, "ext/bench_budget.h: evaluate takes no longer than promised",
     "Compares the time of evaluate with that of copying the declared inputs.", check_budget},
    {"speed.batch-growth", 5,
     "brush.h: a brush is a pointwise function: its time grows as the number of nodes",
     "Compares batches of 1024 and 16384 nodes.", check_growth_with_batch},
    {"speed.denormals", 5, "brush.h: a brush is a pointwise function: no node takes much longer than others",
     "Evaluates nodes whose t and d are denormal.", check_denormals},
};

}  // namespace

std::span<const Check> speed_checks() { return speed_list; }

}  // namespace burin::validate
