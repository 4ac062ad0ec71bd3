// Checks that results are the same, to the bit, however and wherever they are computed.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <string>
#include <thread>

#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

void each_stroke(const Subject& subject, const std::function<void(ProbeStroke&, const Nodes&)>& check) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    check(stroke, random_nodes(2000, subject.seed));
  });
}

void require_same(const std::vector<Row>& a, const std::vector<Row>& b, const Nodes& nodes,
                  const char* fault) {
  const std::string other = difference(a, b, nodes);
  require(other.empty(), std::string(fault) + ": " + other);
}

void check_split(const Subject& subject) {
  each_stroke(subject, [&](ProbeStroke& stroke, const Nodes& nodes) {
    std::mt19937_64 random(subject.seed);
    std::vector<Row> parts;
    for (std::size_t begin = 0; begin < nodes.size();) {
      const std::size_t end = std::min(nodes.size(), begin + 1 + random() % 300);
      const auto part = stroke.evaluate(nodes, begin, end);
      parts.insert(parts.end(), part.begin(), part.end());
      begin = end;
    }
    require_same(stroke.evaluate(nodes), parts, nodes, "smaller batches give another result");
  });
}

void check_order(const Subject& subject) {
  each_stroke(subject, [&](ProbeStroke& stroke, const Nodes& nodes) {
    std::vector<std::size_t> order(nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(subject.seed));
    Nodes shuffled = nodes;
    for (std::size_t column = 0; column < column_count; ++column)
      for (std::size_t i = 0; i < order.size(); ++i)
        shuffled.columns[column][i] = nodes.columns[column][order[i]];
    const auto plain = stroke.evaluate(nodes), rows = stroke.evaluate(shuffled);
    std::vector<Row> back(rows.size());
    for (std::size_t i = 0; i < order.size(); ++i) back[order[i]] = rows[i];
    require_same(plain, back, nodes, "another order of nodes gives another result");
  });
}

void check_threads(const Subject& subject) {
  each_stroke(subject, [&](ProbeStroke& stroke, const Nodes& nodes) {
    const auto alone = stroke.evaluate(nodes);
    std::array<std::vector<Row>, 4> results;
    std::array<std::string, 4> faults;
    {
      std::vector<std::thread> threads;
      for (std::size_t k = 0; k < results.size(); ++k)
        threads.emplace_back([&, k] {
          try {
            const auto start = std::chrono::steady_clock::now();
            while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(50)) {
              results[k] = stroke.evaluate(nodes);
              if (!difference(alone, results[k], nodes).empty()) break;
            }
          } catch (const Failed& failed) {
            faults[k] = failed.what();
          }
        });
      for (std::thread& thread : threads) thread.join();
    }
    for (std::size_t k = 0; k < results.size(); ++k) {
      require(faults[k].empty(), faults[k]);
      require_same(alone, results[k], nodes, "several threads give another result");
    }
  });
}

void check_runs(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    const Nodes nodes = random_nodes(2000, subject.seed);
    ProbeBrush brush(plugin, descriptor, subject);
    const auto draw = [&] { return ProbeStroke(brush).evaluate(nodes); };
    const auto first = draw();
    for (int i = 0; i < 2; ++i) require_same(first, draw(), nodes, "drawn again, it gives another result");
  });
}

/// The bits of a stroke with random values, in a process where no stroke was drawn before, or one with the
/// defaults.
std::string drawn_anew(const Plugin& plugin, const Brush& descriptor, const Subject& subject,
                       std::uint64_t seed, bool after_another) {
  return in_process([&] {
    const Nodes nodes = random_nodes(500, subject.seed);
    ProbeBrush brush(plugin, descriptor, subject);
    if (after_another) ProbeStroke(brush).evaluate(nodes);
    brush.values.set_random(seed);
    return bits_of(ProbeStroke(brush).evaluate(nodes));
  });
}

void check_first_stroke(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    for (std::uint64_t seed = subject.seed; seed < subject.seed + 3; ++seed) {
      std::string alone, again, after;
      try {
        alone = drawn_anew(plugin, descriptor, subject, seed, false);
        again = drawn_anew(plugin, descriptor, subject, seed, false);
        after = drawn_anew(plugin, descriptor, subject, seed, true);
      } catch (const Failed&) {
        throw Skipped("it fails with random values, see life.begin-random");
      }
      if (alone != again) throw Skipped("two processes give different results, see repeat.processes");
      require(alone == after,
              "draws otherwise after a stroke with other values of parameters: it keeps what it made of the "
              "first ones, in static data or in the brush");
    }
  });
}

void check_processes(const Subject& subject) {
  const auto draw = [&subject] {
    std::string bits;
    each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
      ProbeBrush brush(plugin, descriptor, subject);
      bits += bits_of(ProbeStroke(brush).evaluate(random_nodes(2000, subject.seed)));
    });
    return bits;
  };
  require(in_process(draw) == in_process(draw), "two processes give different results");
}

void check_seed(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const burin_brush_descriptor& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const Nodes nodes = random_nodes(2000, subject.seed);
    ProbeStroke stroke(brush);
    const auto plain = stroke.evaluate(nodes);
    burin_stroke_context other = stroke_context();
    other.seed += 1;
    ProbeStroke(brush, other).evaluate(nodes);
    require_same(plain, stroke.evaluate(nodes), nodes,
                 "evaluated again after a stroke of another seed, it gives another result");
  });
}

constexpr Check repeat_list[] = {
    {"repeat.split", 4, "brush.h: the host may split nodes into batches as it likes",
     "Compares one batch with many.", check_split},
    {"repeat.order", 4, "brush.h: evaluate is a pure function of batch elements, in any order",
     "Compares with shuffled nodes.", check_order},
    {"repeat.threads", 4, "brush.h: evaluate may run on many threads at once for one stroke",
     "Compares with four threads.", check_threads},
    {"repeat.runs", 2, "brush.h: evaluate is a pure function of context, parameters and batch",
     "Draws three times.", check_runs},
    {"repeat.first-stroke", 2, "brush.h: evaluate is a pure function of context, parameters and batch",
     "Draws with random values as the first stroke of a process, and after one with the defaults.",
     check_first_stroke},
    {"repeat.processes", 4, "brush.h: evaluate is a pure function of context, parameters and batch",
     "Draws in two processes.", check_processes},
    {"repeat.seed", 4, "stroke.h: seed, so that a stroke drawn again is the same",
     "Draws a stroke of another seed in between.", check_seed},
};

}  // namespace

std::span<const Check> repeat_checks() { return repeat_list; }

}  // namespace burin::validate
