// Checks what evaluate touches: arrays to their ends, what is not declared, memory, files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>
#include <string>

#include "validate/probe/guarded.h"
#include "validate/probe/refused_calls.h"
#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"
#include "validate/probe/traced_calls.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;
constexpr std::size_t guarded_nodes = 257;

using Arrays = std::vector<std::unique_ptr<Guarded>>;

burin_batch guarded_batch(const Nodes& nodes, const burin_params& params, Guard guard, Arrays& arrays) {
  burin_batch batch = batch_of(nodes, 0, nodes.size(), params);
  std::size_t column = 0;
  for (const InputColumns& input : input_columns())
    for (std::size_t k = 0; k < input.count; ++k) {
      arrays.push_back(std::make_unique<Guarded>(nodes.columns[column++], guard));
      array_of(batch, input, k).data = arrays.back()->data();
    }
  return batch;
}

burin_outputs guarded_outputs(std::size_t count, Guard guard, Arrays& arrays) {
  burin_outputs outputs{sizeof outputs, static_cast<std::uint32_t>(count), {}, {}, {}, {}, {}};
  for (burin_floats_out* array : arrays_of(outputs)) {
    arrays.push_back(std::make_unique<Guarded>(std::vector<float>(count), guard));
    *array = {arrays.back()->data(), 1, 0};
  }
  return outputs;
}

/// What evaluate returns with these arrays guarded, or none, in another process; nothing if that does not
/// come to its end.
std::optional<burin_status> evaluated(const ProbeStroke& stroke, const Subject& subject, Guard inputs,
                                      Guard outputs) {
  try {
    return std::stoi(in_process([&] {
      const Nodes nodes = random_nodes(guarded_nodes, subject.seed);
      Arrays arrays;
      const burin_batch batch = guarded_batch(nodes, stroke.params(), inputs, arrays);
      return std::to_string(stroke.call(batch, guarded_outputs(nodes.size(), outputs, arrays)));
    }));
  } catch (const Failed&) {
    return std::nullopt;
  }
}

bool ends_well(const ProbeStroke& stroke, const Subject& subject, Guard inputs, Guard outputs) {
  return evaluated(stroke, subject, inputs, outputs).has_value();
}

/// Calls `check` with an open stroke of each brush. A brush that ends the process anyway, or fails, does so
/// for another reason than those of memory: it is skipped.
void each_sound_stroke(const Subject& subject,
                       const std::function<void(const Plugin&, const Brush&, ProbeStroke&)>& check) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const auto status = evaluated(stroke, subject, Guard::none, Guard::none);
    if (!status) throw Skipped("evaluate ends the process wherever its arrays lie");
    if (*status != BURIN_OK) throw Skipped("evaluate fails, see life.begin-default");
    check(plugin, descriptor, stroke);
  });
}

void check_reads(const Subject& subject) {
  each_sound_stroke(subject, [&](const Plugin&, const Brush&, const ProbeStroke& stroke) {
    require(ends_well(stroke, subject, Guard::before, Guard::none), "reads before the arrays");
    require(ends_well(stroke, subject, Guard::behind, Guard::none), "reads behind the arrays");
  });
}

void check_writes(const Subject& subject) {
  each_sound_stroke(subject, [&](const Plugin&, const Brush&, const ProbeStroke& stroke) {
    require(ends_well(stroke, subject, Guard::none, Guard::before), "writes before the arrays");
    require(ends_well(stroke, subject, Guard::none, Guard::behind), "writes behind the arrays");
  });
}

void check_undeclared_inputs(const Subject& subject) {
  each_sound_stroke(subject, [&](const Plugin&, const Brush& descriptor, const ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(100, subject.seed);
    for (const InputColumns& input : input_columns()) {
      if (descriptor.inputs_read & input.bit) continue;
      const auto evaluate = [&]() -> std::string {
        Arrays arrays;
        burin_batch batch = guarded_batch(nodes, stroke.params(), Guard::none, arrays);
        for (std::size_t k = 0; k < input.count; ++k) array_of(batch, input, k) = {};
        const burin_outputs outputs = guarded_outputs(nodes.size(), Guard::none, arrays);
        require(stroke.call(batch, outputs) == BURIN_OK, "evaluate fails");
        return {};
      };
      try {
        in_process(evaluate);
      } catch (const Failed&) {
        throw Failed(fmt::format("reads the input '{}' without declaring it", input.name));
      }
    }
  });
}

void check_calls(const Subject& subject) {
  require_countable_memory();
  each_sound_stroke(subject, [&](const Plugin& plugin, const Brush&, const ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(300, subject.seed);
    stroke.evaluate(nodes, 0, nodes.size());  // A first call may make what later ones keep.
    std::vector<Row> rows(nodes.size());
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
    const burin_outputs outputs = outputs_of(rows);
    const auto called = calls_during(plugin.entry(), [&] { stroke.call(batch, outputs); });
    require(called.empty(), fmt::format("evaluate calls {} (addr2line -fCe {} tells the lines)",
                                        fmt::join(called, ", "), subject.module.string()));
  });
}

void check_system_calls(const Subject& subject) {
  each_sound_stroke(subject, [&](const Plugin& plugin, const Brush&, const ProbeStroke& stroke) {
    const Nodes nodes = random_nodes(300, subject.seed);
    std::vector<Row> rows(nodes.size());
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
    const burin_outputs outputs = outputs_of(rows);
    stroke.call(batch, outputs);  // A first call may make what later ones keep, as sanitizers do.
    const std::string call = refused_call(&plugin.entry(), [&] { stroke.call(batch, outputs); });
    require(
        call.empty(),
        fmt::format("evaluate opens, reads or writes a file, sleeps, or starts a thread or process: it calls "
                    "{} (addr2line -fCe {} tells the lines)",
                    call, subject.module.string()));
  });
}

constexpr Check memory_list[] = {
    {"memory.reads-within", 2, "stroke.h: count elements",
     "Puts pages that nobody may touch on both sides of all inputs.", check_reads},
    {"memory.writes-within", 2, "stroke.h: count elements",
     "Puts pages that nobody may touch on both sides of all outputs.", check_writes},
    {"memory.undeclared-inputs", 2,
     "stroke.h: an array is null if the brush did not declare it in inputs_read",
     "Evaluates without each of the inputs that are not declared.", check_undeclared_inputs},
    {"memory.allocations", 4, "base.h: what is marked concurrent should neither allocate memory nor lock",
     "Counts calls of malloc, new, mutexes and fopen by the module and its libraries.", check_calls},
    {"memory.system-calls", 4, "base.h: what is marked concurrent must not open files or write to streams",
     "Evaluates where the system refuses such calls.", check_system_calls},
};

}  // namespace

std::span<const Check> memory_checks() { return memory_list; }

}  // namespace burin::validate
