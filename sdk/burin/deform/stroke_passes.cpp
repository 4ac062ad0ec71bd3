// Runs multi-pass brushes incrementally: pass p computes the changed vertices and p rings of neighbours
// around them.
#include <burin/base/sort_unique.h>
#include <burin/deform/stroke_passes.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// The slots of these vertices, vertex by vertex.
std::vector<Index> slots_of(const LiveChart& chart, std::span<const Index> vertices) {
  std::vector<Index> slots;
  for (const Index vertex : vertices)
    for (Index slot = chart.first(vertex); slot != no_index; slot = chart.next(slot)) slots.push_back(slot);
  return slots;
}

}  // namespace

StrokePasses::StrokePasses(const Surface& surface, const BrushStroke& stroke,
                           std::vector<const LiveChart*> charts, const BlendOptions& blend)
    : surface_(&surface), stroke_(&stroke), charts_(std::move(charts)), blend_(blend) {
  blend_.limit = BlendOptions{}.limit;
  for (std::uint32_t pass = 0; pass + 1 < stroke.plan().passes; ++pass)
    results_.push_back({std::vector<NodeOutputs>(charts_.size()), PassPositions(surface, charts_)});
}

std::vector<Index> StrokePasses::update(Evaluator& evaluator, std::span<EvaluatedInstance> instances,
                                        std::vector<Index> vertices) {
  sort_unique(vertices);
  for (std::uint32_t pass = 0; pass < stroke_->plan().passes; ++pass) {
    if (pass > 0) add_neighbours(vertices);
    run(pass, evaluator, instances, vertices);
    if (pass < results_.size()) blend_vertices(pass, instances, vertices);
  }
  return vertices;
}

/// Adds the neighbours of the vertices that have nodes.
void StrokePasses::add_neighbours(std::vector<Index>& vertices) const {
  const auto has_nodes = [this](Index vertex) {
    return std::ranges::any_of(charts_,
                               [&](const LiveChart* chart) { return chart->first(vertex) != no_index; });
  };
  const std::size_t before = vertices.size();
  for (std::size_t i = 0; i < before; ++i)
    for (const Index neighbour : surface_->neighbours[vertices[i]])
      if (has_nodes(neighbour)) vertices.push_back(neighbour);
  sort_unique(vertices);
}

void StrokePasses::run(std::uint32_t pass, Evaluator& evaluator, std::span<EvaluatedInstance> instances,
                       std::span<const Index> vertices) {
  const bool tints = paints(stroke_->descriptor()), last = pass == results_.size();
  for (std::size_t i = 0; i < instances.size(); ++i) {
    EvaluatedInstance& instance = instances[i];
    const std::vector<Index> slots = slots_of(*charts_[i], vertices);
    NodeSource source = instance.source;
    source.before = pass > 0 ? &results_[pass - 1].positions : nullptr;
    NodeOutputs outputs;
    outputs.resize(slots.size(), tints);
    for (std::size_t k = 0; k < slots.size() && pass > 0; ++k)
      outputs.displacement[k] = results_[pass - 1].outputs[i].displacement[slots[k]];
    instance.context.pass = pass;
    evaluator.pass(*stroke_, instance.context, source, slots, outputs);
    if (last) Evaluator::scale(*stroke_, source, slots, instance.strength, outputs);
    NodeOutputs& kept = last ? instance.outputs : results_[pass].outputs[i];
    kept.resize(charts_[i]->nodes().size(), tints);
    for (std::size_t k = 0; k < slots.size(); ++k) kept.take(slots[k], outputs, k);
  }
}

void StrokePasses::blend_vertices(std::uint32_t pass, std::span<const EvaluatedInstance> instances,
                                  std::span<const Index> vertices) {
  PassResult& result = results_[pass];
  std::vector<InstanceSheets> sheets;
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    const NodeSource& source = instances[i].source;
    sheets.push_back({charts_[i], &result.outputs[i], source.nodes.half_width(), source.dab_t});
  }
  std::vector<Vec3f> positions(vertices.size());
  blend_sheets(*surface_, {sheets}, vertices, blend_, stroke_->descriptor().id, positions);
  for (std::size_t i = 0; i < vertices.size(); ++i) result.positions.set(vertices[i], positions[i]);
}

}  // namespace burin
