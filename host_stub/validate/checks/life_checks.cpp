// Checks the lifetimes of brushes and strokes, and values of parameters.
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

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

std::size_t heap_in_use() { return mallinfo2().uordblks; }

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
      const std::string other = difference(alone, open[k]->evaluate(nodes));
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
    const std::string other = difference(alone, stroke.evaluate(nodes));
    require(other.empty(), "another brush changes its stroke: " + other);
  });
}

/// Begins a stroke and evaluates some nodes, with values that `set` makes of the defaults; results are
/// finite.
void try_values(const Subject& subject, const std::function<void(Values&)>& set) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    set(brush.values);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(300, subject.seed);
    for (const Row& row : stroke.evaluate(nodes))
      for (const float number : row) require(std::isfinite(number), "writes a number that is not finite");
  });
}

void check_default(const Subject& subject) {
  try_values(subject, [](Values&) {});
}

void check_least(const Subject& subject) {
  try_values(subject, [](Values& values) { values.set_least(); });
}

void check_greatest(const Subject& subject) {
  try_values(subject, [](Values& values) { values.set_greatest(); });
}

void check_random(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    const Nodes nodes = random_nodes(100, subject.seed);
    for (std::uint64_t seed = subject.seed; seed < subject.seed + 200; ++seed) {
      brush.values.set_random(seed);
      for (const Row& row : ProbeStroke(brush).evaluate(nodes))
        for (const float number : row)
          require(std::isfinite(number),
                  fmt::format("writes a number that is not finite, with values of seed {}", seed));
    }
  });
}

/// Begins a stroke with each of these texts for each parameter of the type. Whether it can is the brush's
/// affair; a text of its error is not.
void try_texts(const Subject& subject, burin_param_type type, const std::vector<std::string>& texts) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    bool any = false;
    for (std::uint32_t i = 0; i < descriptor.param_count; ++i) {
      if (descriptor.params[i]->type != type) continue;
      any = true;
      for (const std::string& text : texts) {
        ProbeBrush brush(plugin, descriptor, subject);
        brush.values.set_text(i, text);
        std::array<char, 400> line{};
        burin_text error{sizeof error, 400, line.data()};
        burin_stroke_plan plan{sizeof plan, 1, 0};
        void* stroke = nullptr;
        const burin_stroke_context context = empty_stroke_context();
        const burin_status status =
            brush.abi().begin(&brush.abi(), &context, &brush.values.abi(), &plan, &stroke, &error);
        if (status == BURIN_OK) brush.abi().end(&brush.abi(), stroke);
        require(status != BURIN_STATUS_UNKNOWN, "begin returns no status");
        require(status == BURIN_OK || line[0],
                fmt::format("begin fails without a text, parameter '{}'", descriptor.params[i]->id));
      }
    }
    if (!any) throw Skipped("it has no parameter of this type");
  });
}

/// Values that hosts never pass: beyond the ends of the range, or no numbers.
std::vector<float> outside(const burin_param_info& info) {
  using Limits = std::numeric_limits<float>;
  const bool colour = info.type == BURIN_PARAM_COLOUR;
  const float low = colour ? 0 : least_of(info), high = colour ? 1 : greatest_of(info);
  return {low - 1,
          high + 1,
          Limits::lowest(),
          Limits::max(),
          Limits::quiet_NaN(),
          Limits::infinity(),
          -Limits::infinity()};
}

/// Draws with a parameter at this value, in another process that is ended after a while. Returns whether
/// begin took it.
bool draws_with(const Subject& subject, const Plugin& plugin, const Brush& descriptor, std::uint32_t param,
                float value) {
  const auto draw = [&]() -> std::string {
    alarm(5);
    ProbeBrush brush(plugin, descriptor, subject);
    brush.values.set_number(param, value);
    try {
      const Nodes nodes = random_nodes(64, subject.seed);
      std::vector<Row> rows(nodes.size());
      const ProbeStroke stroke(brush);
      stroke.call(batch_of(nodes, 0, nodes.size(), stroke.params()), outputs_of(rows));
    } catch (const Error&) {
      return "refused";
    }
    return {};
  };
  try {
    return in_process(draw).empty();
  } catch (const Failed&) {
    throw Failed(fmt::format("parameter '{}': crashes or takes more than 5 seconds with {}",
                             descriptor.params[param]->id, value));
  }
}

void check_outside(const Subject& subject) {
  bool any = false;
  std::vector<std::string> taken;
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    for (std::uint32_t i = 0; i < descriptor.param_count; ++i) {
      const burin_param_info& info = *descriptor.params[i];
      if (info.type < BURIN_PARAM_FLOAT || info.type > BURIN_PARAM_COLOUR) continue;
      any = true;
      bool all_refused = true;
      for (const float value : outside(info))
        all_refused &= !draws_with(subject, plugin, descriptor, i, value);
      if (!all_refused) taken.emplace_back(info.id);
    }
  });
  if (!any) throw Skipped("it has no numbers");
  throw Told(taken.empty() ? "begin refuses them"
                           : fmt::format("begin takes some of {}", fmt::join(taken, ", ")));
}

void check_text_values(const Subject& subject) {
  try_texts(subject, BURIN_PARAM_TEXT,
            {"", "A", std::string(5000, 'm'), "\xC3\xA9\xE4\xB8\xAD", "\xFF\xFE", "%s%n", " "});
}

void check_files(const Subject& subject) {
  try_texts(subject, BURIN_PARAM_FILE,
            {"", "/nowhere/there.exr", subject.folder.string(), "\xFF\xFE.exr", std::string(5000, 'x'),
             subject.module.string()});
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
    {"life.begin-default", 1, "brush.h: begin; stroke.h: every value written must be finite",
     "Draws with the defaults of all parameters.", check_default},
    {"life.begin-least", 2, "param.h: values lie within the hard range, its ends included",
     "Draws with every number at its least.", check_least},
    {"life.begin-greatest", 2, "param.h: values lie within the hard range, its ends included",
     "Draws with every number at its greatest.", check_greatest},
    {"life.begin-random", 3, "param.h: values lie within the hard range",
     "Draws with random values, 200 times.", check_random},
    {"life.outside-values", 3,
     "param.h: hosts pass no values outside the hard range; with such a brush may fail but should not crash",
     "Draws with numbers and colours beyond their ranges, infinite, and that are none.", check_outside},
    {"life.text-values", 3, "param.h: TEXT, a line of UTF-8, may be empty; brush.h: begin checks parameters",
     "Begins with empty, long and damaged texts.", check_text_values},
    {"life.file-values", 3, "param.h: FILE, a path; brush.h: begin checks parameters, opens files",
     "Begins with no file, missing ones, a folder, damaged names.", check_files},
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
