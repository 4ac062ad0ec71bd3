// Evaluates nodes in the order of their dependencies: first those without an earlier visit around them, then
// those that depend on these, and so on. An event costs O(n log n) for the n nodes that it changes and that
// depend on them.
#include <burin/deform/accumulation.h>
#include <burin/deform/evaluate/displacement.h>
#include <burin/surface/geometry/normals.h>
#include <burin/surface/geometry/unit_tangent.h>
#include <burin/surface/topology/surroundings.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace burin {

void Accumulation::update(Evaluator& evaluator, EvaluatedInstance& instance, const LiveChart& chart,
                          std::span<const Index> vertices, std::vector<Index>& reached) const {
  const std::vector<Due> due = due_nodes(chart, vertices);
  for (auto first = due.begin(); first != due.end();) {
    const auto last =
        std::find_if(first, due.end(), [&](const Due& node) { return node.after != first->after; });
    std::vector<Index> slots;
    for (auto node = first; node != last; ++node) slots.push_back(node->slot);
    evaluate(evaluator, instance, chart, slots);
    for (const Index slot : slots) reached.push_back(chart.nodes().vertex[slot]);
    first = last;
  }
}

/// Whether node a belongs to an earlier visit than node b. Across the seam of a closed stroke a visit
/// continues.
bool Accumulation::earlier(const Chart& nodes, Index a, Index b) const {
  const double before = nodes.t[b] - nodes.t[a];
  const double around = nodes.closed ? std::min(before, nodes.length - before) : before;
  return before > 0 && around > apart_;
}

/// Calls visit(slot) for the nodes of a slot's vertex and of the vertex's neighbours.
template <class Visit>
void Accumulation::for_each_around(const LiveChart& chart, Index slot, const Visit& visit) const {
  const auto visit_nodes = [&](Index vertex) {
    for (Index other = chart.first(vertex); other != no_index; other = chart.next(other)) visit(other);
  };
  const Index vertex = chart.nodes().vertex[slot];
  visit_nodes(vertex);
  for (const Index neighbour : surface_->neighbours[vertex]) visit_nodes(neighbour);
}

/// Calls visit(slot) for the nodes of earlier visits among them, on which the slot's node depends.
template <class Visit>
void Accumulation::for_each_earlier(const LiveChart& chart, Index slot, const Visit& visit) const {
  for_each_around(chart, slot, [&](Index other) {
    if (earlier(chart.nodes(), other, slot)) visit(other);
  });
}

/// Appends the nodes around these that depend on them.
void Accumulation::add_later(const LiveChart& chart, std::span<const Index> from,
                             std::vector<Index>& slots) const {
  for (const Index slot : from)
    for_each_around(chart, slot, [&](Index other) {
      if (earlier(chart.nodes(), slot, other)) slots.push_back(other);
    });
}

/// The nodes of the vertices and of their neighbours (a vertex may have lost a node), and all nodes that
/// depend on them, in an order in which they can be computed.
std::vector<Accumulation::Due> Accumulation::due_nodes(const LiveChart& chart,
                                                       std::span<const Index> vertices) const {
  std::map<Index, int> after;
  std::vector<Index> front;
  const auto take = [&](Index slot) {
    if (after.emplace(slot, 0).second) front.push_back(slot);
  };
  const auto take_nodes = [&](Index vertex) {
    for (Index slot = chart.first(vertex); slot != no_index; slot = chart.next(slot)) take(slot);
  };
  for (const Index vertex : vertices) {
    take_nodes(vertex);
    for (const Index neighbour : surface_->neighbours[vertex]) take_nodes(neighbour);
  }
  while (!front.empty()) {
    std::vector<Index> later;
    add_later(chart, std::exchange(front, {}), later);
    for (const Index slot : later) take(slot);
  }
  std::vector<Due> due;
  due.reserve(after.size());
  for (const auto& [slot, none] : after) due.push_back({slot, none});
  std::ranges::sort(due, {},
                    [&](const Due& node) { return std::pair(chart.nodes().t[node.slot], node.slot); });
  for (Due& node : due) {
    for_each_earlier(chart, node.slot, [&](Index other) {
      if (const auto found = after.find(other); found != after.end())
        node.after = std::max(node.after, found->second + 1);
    });
    after[node.slot] = node.after;
  }
  std::ranges::stable_sort(due, {}, &Due::after);
  return due;
}

/// The position of a vertex as a node sees it, after all visits before the node's. `position` is the vertex's
/// position before the stroke.
Vec3f Accumulation::left_at(Vec3f position, const EvaluatedInstance& instance, const LiveChart& chart,
                            Index vertex, Index slot) const {
  const std::vector<Vec3f>& displacement = instance.outputs.displacement;
  for (Index other = chart.first(vertex); other != no_index; other = chart.next(other))
    if (earlier(chart.nodes(), other, slot))
      position += in_space(chart.nodes().e1[other], chart.nodes().normal[other], displacement[other]);
  return position;
}

/// The geometry that a node starts from. The relief of earlier visits is as wide as the brush, so it is part
/// of the base surface of later ones.
CurrentBase::Geometry Accumulation::geometry_of(const EvaluatedInstance& instance, const LiveChart& chart,
                                                Index slot) const {
  const Index vertex = chart.nodes().vertex[slot];
  const auto fine = [&](Index v) { return left_at(surface_->positions[v], instance, chart, v, slot); };
  const auto base = [&](Index v) {
    return left_at(instance.source.base_position(v), instance, chart, v, slot);
  };
  const auto normal = [&](const auto& position) {
    return vertex_normal(surface_->triangles, surface_->incident, vertex, position);
  };
  CurrentBase::Geometry geometry;
  geometry.fine_position = fine(vertex);
  geometry.fine_normal = normal(fine);
  geometry.laplacian = umbrella(*surface_, vertex, fine);
  geometry.position = instance.source.base ? base(vertex) : geometry.fine_position;
  geometry.normal = instance.source.base ? normal(base) : geometry.fine_normal;
  geometry.e1 = unit_tangent(chart.nodes().e1[slot], geometry.normal);
  return geometry;
}

void Accumulation::evaluate(Evaluator& evaluator, EvaluatedInstance& instance, const LiveChart& chart,
                            std::span<const Index> slots) const {
  CurrentBase current;
  for (const Index slot : slots) {
    bool stands_on_others = false;
    for_each_earlier(chart, slot, [&](Index) { stands_on_others = true; });
    if (stands_on_others) current.set(slot, geometry_of(instance, chart, slot));
  }
  NodeSource source = instance.source;
  source.current = &current;
  const NodeOutputs& outputs =
      evaluator.evaluate(*stroke_, instance.context, source, slots, instance.strength);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Index slot = slots[i];
    instance.outputs.take(slot, outputs, i);
    const CurrentBase::Geometry* geometry = current.find(slot);
    if (!geometry) continue;
    const Vec3f vector = in_space(geometry->e1, geometry->normal, outputs.displacement[i]);
    const Vec3f& normal = chart.nodes().normal[slot];
    instance.outputs.displacement[slot] = in_frame(chart.nodes().e1[slot], normal, vector);
  }
}

}  // namespace burin
