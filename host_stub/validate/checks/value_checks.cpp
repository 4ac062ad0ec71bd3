// Checks drawing with values of parameters: defaults, ends of ranges, random ones, beyond ranges, texts,
// files.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;

/// Begins a stroke and evaluates some nodes, with values that `set` makes of the defaults; results are
/// finite.
void try_values(const Subject& subject, const std::function<void(Values&)>& set) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    set(brush.values);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(300, subject.seed);
    require_finite(stroke.evaluate(nodes), nodes);
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
    for (std::uint64_t i = 0; i < 200; ++i) {
      brush.values.set_random(subject.seed + i);
      tell_where(fmt::format("with {} it ", brush.values.told()),
                 [&] { require_finite(ProbeStroke(brush).evaluate(nodes), nodes); });
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
        require(brush.begins(&error) || line[0],
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

/// Draws with an image or a solid for an optional file. Returns whether begin took one of them.
bool draws_with_file(const Subject& subject, const Plugin& plugin, const Brush& descriptor,
                     std::uint32_t param) {
  for (const auto& file : {subject.stamp, subject.solid}) {
    ProbeBrush brush(plugin, descriptor, subject);
    brush.values.set_text(param, file.string());
    if (!brush.begins()) continue;
    const Nodes nodes = random_nodes(500, subject.seed);
    ProbeStroke stroke(brush);
    const auto rows = stroke.evaluate(nodes);
    require_finite(rows, nodes);
    require(difference(rows, stroke.evaluate(nodes), nodes).empty(), "draws otherwise each time");
    return true;
  }
  return false;
}

void check_optional_files(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    std::string reason = "it has no optional file";
    bool drew = false;
    for (std::uint32_t i = 0; i < descriptor.param_count; ++i) {
      const burin_param_info& info = *descriptor.params[i];
      if (info.type != BURIN_PARAM_FILE || !info.default_file) continue;
      bool taken = false;
      tell_where(fmt::format("with a file for '{}' it ", info.id),
                 [&] { taken = draws_with_file(subject, plugin, descriptor, i); });
      drew |= taken;
      if (!taken)
        reason = fmt::format("'{}' takes neither an image nor an OpenVDB file; give one by --param", info.id);
    }
    if (!drew) throw Skipped(reason);
  });
}

constexpr Check value_list[] = {
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
    {"life.optional-files", 2, "param.h: FILE, a path; stroke.h: every value written must be finite",
     "Draws with an image or an OpenVDB file where none is needed.", check_optional_files},
};

}  // namespace

std::span<const Check> value_checks() { return value_list; }

}  // namespace burin::validate
