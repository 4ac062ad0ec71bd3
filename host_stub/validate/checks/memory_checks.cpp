// Checks what evaluate touches: arrays to their ends, what is not declared, memory, files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "validate/probe/guarded.h"
#include "validate/probe/repeat.h"
#include "validate/probe/stroke.h"
#include "validate/probe/traced_calls.h"

namespace burin::validate {
namespace {

using Brush = burin_brush_descriptor;
constexpr std::size_t guarded_nodes = 257;

using Arrays = std::vector<std::unique_ptr<Guarded>>;

burin_batch guarded_batch(const Nodes& nodes, const burin_params& params, bool at_end, Arrays& arrays) {
  burin_batch batch = batch_of(nodes, 0, nodes.size(), params);
  std::size_t column = 0;
  for (const InputColumns& input : input_columns())
    for (std::size_t k = 0; k < input.count; ++k) {
      arrays.push_back(std::make_unique<Guarded>(nodes.columns[column++], at_end));
      array_of(batch, input, k).data = arrays.back()->data();
    }
  return batch;
}

burin_outputs guarded_outputs(std::size_t count, bool at_end, Arrays& arrays) {
  burin_outputs outputs{sizeof outputs, static_cast<std::uint32_t>(count), {}, {}, {}, {}, {}};
  for (burin_floats_out* array : arrays_of(outputs)) {
    arrays.push_back(std::make_unique<Guarded>(std::vector<float>(count), at_end));
    *array = {arrays.back()->data(), 1, 0};
  }
  return outputs;
}

/// Evaluates with guarded inputs, or outputs, in another process, so that a fault is told as what it is.
void evaluate_guarded(const Subject& subject, bool inputs, const char* fault) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    for (const bool at_end : {false, true}) {
      const auto evaluate = [&]() -> std::string {
        Nodes nodes = random_nodes(guarded_nodes, subject.seed);
        std::vector<Row> rows(nodes.size());
        Arrays arrays;
        stroke.call(inputs ? guarded_batch(nodes, stroke.params(), at_end, arrays)
                           : batch_of(nodes, 0, nodes.size(), stroke.params()),
                    inputs ? outputs_of(rows) : guarded_outputs(nodes.size(), at_end, arrays));
        return {};
      };
      try {
        in_process(evaluate);
      } catch (const Failed&) {
        throw Failed(fmt::format("{} {} the arrays", fault, at_end ? "behind" : "before"));
      }
    }
  });
}

void check_reads(const Subject& subject) { evaluate_guarded(subject, true, "reads"); }
void check_writes(const Subject& subject) { evaluate_guarded(subject, false, "writes"); }

void check_undeclared_inputs(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
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
        throw Failed(
            fmt::format("reads an input that it does not declare, bit {:#x} of inputs_read", input.bit));
      }
    }
  });
}

void check_calls(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(300, subject.seed);
    stroke.evaluate(nodes);  // A first call may make what later ones keep.
    std::vector<Row> rows(nodes.size());
    const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
    const burin_outputs outputs = outputs_of(rows);
    const auto called = calls_during(plugin.entry(), [&] { stroke.call(batch, outputs); });
    require(called.empty(), fmt::format("evaluate calls {} (addr2line -fCe {} tells the lines)",
                                        fmt::join(called, ", "), subject.module.string()));
  });
}

void check_system_calls(const Subject& subject) {
  each_brush(subject, [&](const Plugin& plugin, const Brush& descriptor) {
    ProbeBrush brush(plugin, descriptor, subject);
    ProbeStroke stroke(brush);
    const Nodes nodes = random_nodes(300, subject.seed);
    // The process that is refused system calls cannot tell, so it is judged by how it ends.
    const auto evaluate = [&]() -> std::string {
      std::vector<Row> rows(nodes.size());
      const burin_batch batch = batch_of(nodes, 0, nodes.size(), stroke.params());
      const burin_outputs outputs = outputs_of(rows);
      without_system_calls([&] { stroke.call(batch, outputs); });
      return {};
    };
    try {
      in_process(evaluate);
    } catch (const Failed&) {
      throw Failed("evaluate opens, reads or writes a file, sleeps, or starts a thread or process");
    }
  });
}

constexpr Check checks[] = {
    {"memory.reads-within", 2, "stroke.h: count elements",
     "Puts pages that nobody may touch on both sides of all inputs.", check_reads},
    {"memory.writes-within", 2, "stroke.h: count elements",
     "Puts pages that nobody may touch on both sides of all outputs.", check_writes},
    {"memory.undeclared-inputs", 2,
     "stroke.h: an array is null if the brush did not declare it in inputs_read",
     "Evaluates without each of the inputs that are not declared.", check_undeclared_inputs},
    {"memory.allocations", 4, "base.h: what is marked concurrent should neither allocate memory nor lock",
     "Counts the module's calls of malloc, new, mutexes and fopen.", check_calls},
    {"memory.system-calls", 4, "base.h: what is marked concurrent must not open files or write to streams",
     "Evaluates where the system refuses such calls.", check_system_calls},
};

}  // namespace

std::span<const Check> memory_checks() { return checks; }

}  // namespace burin::validate
