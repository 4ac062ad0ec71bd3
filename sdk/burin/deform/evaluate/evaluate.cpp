// Calls brushes in batches of up to 1024 nodes on all threads and checks what they return.
#include <burin/base/parallel.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/deform/evaluate/evaluate.h>
#include <burin/deform/evaluate/first_failure.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace burin {

namespace {

/// The arguments of one pass over the nodes.
struct Pass {
  const BrushStroke& stroke;
  const burin_stroke_context& context;
  const NodeSource& source;
  std::span<const Index> nodes;
  NodeOutputs& outputs;
  FirstFailure& failure;
};

std::string displacement_fault(double distance) {
  if (!std::isfinite(distance)) return "returned a displacement that is not finite";
  return fmt::format("returned a displacement of {:.3g}, more than {} radii", distance,
                     farthest_displacement);
}

/// Computes the elements [begin, end) of the pass.
void evaluate_batch(const Pass& pass, Batch& batch, std::size_t begin, std::size_t end) {
  const std::span displacement = std::span(pass.outputs.displacement).subspan(begin, end - begin);
  batch.fill(pass.source, pass.stroke.descriptor().inputs_read, pass.stroke.descriptor().outputs_written,
             pass.stroke.params(), pass.nodes.subspan(begin, end - begin),
             pass.context.pass == 0 ? std::span<const Vec3f>{} : displacement);
  ErrorText error;
  const burin_status status =
      pass.stroke.evaluate(pass.context, batch.inputs(), batch.outputs(), error.abi());
  if (status != BURIN_OK) return pass.failure.note(begin, error.line(status));
  const bool tints = !pass.outputs.tint.empty();
  const double farthest = double{farthest_displacement} * pass.source.radius;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    displacement[i] = batch.displacement(i);
    if (const double distance = displacement[i].cast<double>().norm(); !(distance <= farthest))
      return pass.failure.note(begin + i, displacement_fault(distance));
    if (!tints) continue;
    pass.outputs.tint[begin + i] = batch.tint(i);
    if (!pass.outputs.tint[begin + i].allFinite())
      return pass.failure.note(begin + i, "returned a colour or mask that is not finite");
  }
}

/// Interpolates between the tint before and the written one. The mask protects the colour but not itself.
Tint mixed(const Tint& before, const Tint& written, float strength, float mask) {
  const float share = std::clamp(strength, 0.0f, 1.0f);
  Tint tint = before;
  tint.head<4>() += share * mask * (written - before).head<4>();
  tint[4] += share * (written[4] - before[4]);
  return tint.cwiseMax(0).cwiseMin(1);
}

void throw_if_any(const FirstFailure& failure, const BrushStroke& stroke, const NodeSource& source,
                  std::span<const Index> nodes) {
  if (failure.any()) failure.throw_at(stroke.descriptor().id, source.nodes.chart(), nodes[failure.element()]);
}

}  // namespace

bool paints(const burin_brush_descriptor& brush) {
  return brush.outputs_written & (BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR);
}

void Evaluator::pass(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
                     std::span<const Index> nodes, NodeOutputs& outputs) {
  if (source.dab_t.empty()) return run(stroke, context, source, nodes, outputs);
  const std::vector<double>& t = source.nodes.chart().t;
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return t[nodes[i]]; });
  for (auto first = order.begin(); first != order.end();) {
    const double dab_t = t[nodes[*first]];
    const auto last = std::find_if(first, order.end(), [&](std::size_t i) { return t[nodes[i]] != dab_t; });
    run_dab(stroke, context, source, nodes, std::span(first, last), outputs);
    first = last;
  }
}

void Evaluator::run_dab(const BrushStroke& stroke, const burin_stroke_context& context,
                        const NodeSource& source, std::span<const Index> nodes,
                        std::span<const std::size_t> chosen, NodeOutputs& outputs) {
  burin_stroke_context of_dab = context;
  of_dab.flags = (of_dab.flags | BURIN_STROKE_DAB | BURIN_STROKE_FINAL) & ~BURIN_STROKE_CLOSED;
  of_dab.length = 0;
  of_dab.dab_t = source.nodes.chart().t[nodes[chosen.front()]];
  std::vector<Index> of_nodes;
  NodeOutputs dab;
  dab.resize(chosen.size(), !outputs.tint.empty());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    of_nodes.push_back(nodes[chosen[k]]);
    dab.displacement[k] = outputs.displacement[chosen[k]];
  }
  run(stroke, of_dab, source, of_nodes, dab);
  for (std::size_t k = 0; k < chosen.size(); ++k) outputs.take(chosen[k], dab, k);
}

void Evaluator::run(const BrushStroke& stroke, const burin_stroke_context& context, const NodeSource& source,
                    std::span<const Index> nodes, NodeOutputs& outputs) {
  FirstFailure failure;
  const Pass pass{stroke, context, source, nodes, outputs, failure};
  parallel_blocks(nodes.size(), Batch::capacity, [&](std::size_t begin, std::size_t end) {
    if (failure.lies_before(begin)) return;
    std::unique_ptr<Batch> batch = pool_.take();
    evaluate_batch(pass, *batch, begin, end);
    pool_.give_back(std::move(batch));
  });
  throw_if_any(failure, stroke, source, nodes);
}

void Evaluator::scale(const BrushStroke& stroke, const NodeSource& source, std::span<const Index> nodes,
                      float strength, NodeOutputs& outputs) {
  const Paint& paint = source.painted();
  FirstFailure failure;
  parallel_blocks(nodes.size(), Batch::capacity, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index vertex = source.nodes.chart().vertex[nodes[i]];
      const float mask = paint.mask_of(vertex);
      const float at_node = strength * source.nodes.dynamics().strength(nodes[i]);
      outputs.displacement[i] *= at_node * mask;
      if (!outputs.displacement[i].allFinite())
        return failure.note(i, "displaces beyond the range of floats");
      if (outputs.tint.empty()) continue;
      outputs.tint[i] = mixed(tint_of(paint.colour_of(vertex), mask), outputs.tint[i], at_node, mask);
    }
  });
  throw_if_any(failure, stroke, source, nodes);
}

const NodeOutputs& Evaluator::evaluate(const BrushStroke& stroke, const burin_stroke_context& context,
                                       const NodeSource& source, std::span<const Index> nodes,
                                       float strength) {
  outputs_.resize(nodes.size(), paints(stroke.descriptor()));
  burin_stroke_context now = context;
  for (now.pass = 0; now.pass < stroke.plan().passes; ++now.pass) pass(stroke, now, source, nodes, outputs_);
  scale(stroke, source, nodes, strength, outputs_);
  return outputs_;
}

}  // namespace burin
