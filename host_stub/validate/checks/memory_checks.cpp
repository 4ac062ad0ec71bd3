// Checks what evaluate touches: arrays to their ends, what is not declared, memory, files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

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

/// Evaluates with these arrays guarded, or none, in another process. Returns whether that came to its end.
bool ends_well(const ProbeStroke& stroke, const Subject& subject, Guard inputs, Guard outputs) {
  try {
    in_process([&]() -> std::string {
      const Nodes nodes = random_nodes(guarded_nodes, subject.seed);
      Arrays arrays;
      stroke.call(guarded_batch(nodes, stroke.params(), inputs, arrays),
                  guarded_outputs(nodes.size(), outputs, arrays));
      return {};
    });
    return true;
  } catch (const Failed&) {
    return false;
  }
}

/// Calls `check` with an open stroke of each brush. A brush that ends the process anyway, or fails, does so
/// for another reason than those of memory: it is skipped.
void each_sound_stroke(const Subject& subject,
                       const std::function<void(const Plugin&, const Brush&, ProbeStroke&)>& check) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    if (!ends_well(stroke, subject, Guard::none, Guard::none))
      throw Skipped("evaluate ends the process wherever its arrays lie");
    const Nodes nodes = random_nodes(guarded_nodes, subject.seed);
    std::vector<Row> rows(nodes.size());
    if (stroke.call(batch_of(nodes, 0, nodes.size(), stroke.params()), outputs_of(rows)) != BURIN_OK)
      throw Skipped("evaluate fails, see life.begin-default");
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
        burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
        for (std::size_t k = 0; k < input.count; ++k) array_of(batch, input, k) = {};
        std::vector<Row> rows(nodes.size());
        require(stroke.call(batch, outputs_of(rows)) == BURIN_OK, "evaluate fails");
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
