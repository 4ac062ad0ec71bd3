// Checks of times, which hold for a machine that is not busy.
#include <burin/abi/ext/bench_budget.h>
#include <burin/base/stopwatch.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

/// The least time of some runs, nanoseconds.
double least_time(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    const Stopwatch watch;
    work();
    least = std::min(least, 1e9 * watch.elapsed());
  }
  return least;
}

/// Time of evaluate, nanoseconds per node.
double evaluate_time(ProbeStroke& stroke, const Nodes& nodes) {
  std::vector<Row> rows(nodes.size());
  const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
  const burin_outputs outputs = outputs_of(rows);
  return least_time(15, [&] { stroke.call(batch, outputs); }) / static_cast<double>(nodes.size());
}

/// Time of copying the declared inputs, nanoseconds per node.
double copy_time(const Brush& brush, const Nodes& nodes) {
  std::vector<const std::vector<float>*> declared;
  std::size_t column = 0;
  for (const InputColumns& input : input_columns())
    for (std::size_t k = 0; k < input.count; ++k, ++column)
      if (brush.inputs_read & input.bit) declared.push_back(&nodes.columns[column]);
  std::vector<float> copy(nodes.size());
  volatile float sink = 0;
  return least_time(15,
                    [&] {
                      for (const auto* from : declared) {
                        std::copy(from->begin(), from->end(), copy.begin());
                        sink = copy[copy.size() / 2];
                      }
                    }) /
         static_cast<double>(nodes.size());
}

void check_budget(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const auto* budget = brush.interface<burin_bench_budget>(BURIN_EXT_BENCH_BUDGET);
    if (!budget) throw Skipped("it does not offer " BURIN_EXT_BENCH_BUDGET);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(4096, subject.seed);
    const double time = evaluate_time(stroke, nodes), copy = copy_time(descriptor, nodes);
    const double promised = budget->evaluate_cost(&brush.abi(), &stroke.params());
    require(time <= promised * copy,
            fmt::format("takes {:.1f} ns a node, {:.0f} times a copy, and promised {:.0f} times", time,
                        time / copy, promised));
  });
}

void check_growth(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const Nodes small = random_nodes(1024, subject.seed), large = random_nodes(16384, subject.seed);
    const double few = evaluate_time(stroke, small), many = evaluate_time(stroke, large);
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
    const double normal = evaluate_time(stroke, plain), denormal = evaluate_time(stroke, tiny);
    require(denormal <= 20 * normal + 50,
            fmt::format("takes {:.1f} ns a node, {:.1f} ns where t and d are denormal", normal, denormal));
  });
}

constexpr Check checks[] = {
    {"speed.budget", 5, "ext/bench_budget.h: evaluate takes no longer than promised",
     "Compares with copying the declared inputs.", check_budget},
    {"speed.batch-growth", 5,
     "brush.h: a brush is a pointwise function: its time grows as the number of nodes",
     "Compares batches of 1024 and 16384 nodes.", check_growth},
    {"speed.denormals", 5, "brush.h: a brush is a pointwise function: no node takes much longer than others",
     "Evaluates nodes whose t and d are denormal.", check_denormals},
};

}  // namespace

std::span<const Check> speed_checks() { return checks; }

}  // namespace burin::validate
