// Checks the lifetimes of brushes and strokes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"
#include "validate/probe/traced_calls.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

/// Bytes of the heap of the C library. Throws Skipped where another serves malloc.
std::size_t heap_in_use() {
  require_countable_memory();
  return mallinfo2().uordblks;
}

void check_growth(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& brush) {
    const auto live = [&](int times) {
      for (int i = 0; i < times; ++i) const ProbeBrush made(plugin, brush, subject);
      return heap_in_use();
    };
    const std::size_t before = live(100), after = live(1000);
    require(after <= before + 8000, fmt::format("1000 brushes leave {} bytes", after - before));
  });
}

void check_stroke_growth(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const auto live = [&](int times) {
      for (int i = 0; i < times; ++i) const ProbeStroke stroke(brush);
      return heap_in_use();
    };
    const std::size_t before = live(100), after = live(300);  // the host's own tables grow at first
    require(after <= before + 12000, fmt::format("300 strokes leave {} bytes", after - before));
  });
}

void check_many_strokes(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const Nodes nodes = random_nodes(300, subject.seed);
    const auto alone = ProbeStroke(brush).evaluate(nodes);
    std::array<std::optional<ProbeStroke>, 5> open;
    for (auto& stroke : open) stroke.emplace(brush);
    for (const std::size_t k : {2, 0, 4, 1, 3}) {
      const std::string other = difference(alone, open[k]->evaluate(nodes), nodes);
      require(other.empty(), "of five open strokes one differs from a stroke by itself: " + other);
      open[k].reset();
    }
  });
}

void check_two_brushes(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush first(plugin, descriptor, subject);
    const Nodes nodes = random_nodes(300, subject.seed);
    ProbeStroke stroke(first);
    const auto alone = stroke.evaluate(nodes);
    {
      ProbeBrush second(plugin, descriptor, subject);
      second.values.set_greatest();
      ProbeStroke(second).evaluate(nodes);
    }
    const std::string other = difference(alone, stroke.evaluate(nodes), nodes);
    require(other.empty(), "another brush changes its stroke: " + other);
  });
}

void check_end_after_failure(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    Nodes nodes = random_nodes(64, subject.seed);
    for (auto& column : nodes.columns)
      std::fill(column.begin(), column.end(), std::numeric_limits<float>::quiet_NaN());
    for (int i = 0; i < 20; ++i) {
      ProbeStroke stroke(brush);
      std::vector<Row> rows(nodes.size());
      stroke.call(batch_of(nodes, 0, nodes.size(), stroke.params()), outputs_of(rows));
    }
    ProbeStroke(brush).evaluate(random_nodes(64, subject.seed));
  });
}

constexpr Check life_list[] = {
    {"life.brushes-freed", 3, "brush.h: destroy frees the brush", "Creates and destroys 1000 brushes.",
     check_growth},
    {"life.strokes-freed", 3, "brush.h: end ends a stroke", "Begins and ends 300 strokes.",
     check_stroke_growth},
    {"life.many-strokes", 2, "brush.h: several strokes of one brush may be open at once",
     "Ends five strokes in another order than they began.", check_many_strokes},
    {"life.two-brushes", 2, "brush.h: evaluate is a pure function of context, parameters and batch",
     "Draws with a second brush of other values in between.", check_two_brushes},
    {"life.end-after-failure", 3, "brush.h: end is called whether or not evaluate failed",
     "Ends strokes after a batch of numbers that are none.", check_end_after_failure},
};

}  // namespace

std::span<const Check> life_checks() { return life_list; }

}  // namespace burin::validate
