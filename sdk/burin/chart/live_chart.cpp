// Stores a chart in slots. Slots of one vertex form a linked list in the order of t; setting or removing a
// node costs O(1) and the few sheets of its vertex, sorted() O(n) in the number of nodes.
#include <burin/base/index_set.h>
#include <burin/chart/live_chart.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace burin {
namespace {

/// Orders the sheets of a vertex by t. Those of equal t, which two visits have where the same place of the
/// stroke is nearest to both, are ordered by the rest of their frames, so that the order in which they came
/// decides nothing.
bool is_sheet_before(const Chart& nodes, Index a, Index b) {
  if (nodes.t[a] != nodes.t[b]) return nodes.t[a] < nodes.t[b];
  const auto rest = [&nodes](Index slot) {
    const Vec3f& e1 = nodes.e1[slot];
    return std::tuple(nodes.d[slot], e1.x(), e1.y(), e1.z(), nodes.curvature[slot], nodes.stretch[slot]);
  };
  return rest(a) < rest(b);
}

}  // namespace

Index LiveChart::first(Index vertex) const {
  const Index local = local_indices_.find(vertex);
  return local == no_index ? no_index : first_[local];
}

std::uint32_t LiveChart::sheet_count(Index vertex) const {
  std::uint32_t count = 0;
  for (Index slot = first(vertex); slot != no_index; slot = next(slot)) ++count;
  return count;
}

void LiveChart::clear() {
  nodes_.resize(0);
  states_.clear();
  local_index_of_.clear();
  next_.clear();
  changed_in_.clear();
  contested_.clear();
  local_indices_.clear();
  first_.clear();
  altered_in_.clear();
  begin_event(0, false, 0);
}

void LiveChart::begin_event(double length, bool closed, double computed_from) {
  ++event_;
  nodes_.length = length;
  nodes_.closed = closed;
  computed_from_ = computed_from;
  computed_.clear();
  removed_.clear();
  altered_.clear();
}

void LiveChart::set(Index slot, Index vertex, const ChartFrame& frame, const Vec3f& normal, bool contested) {
  if (slot >= nodes_.size()) reserve(slot + 1);
  computed_.push_back(slot);
  const bool was_contested = std::exchange(contested_[slot], static_cast<std::uint8_t>(contested));
  if (!vacant(slot) && was_contested == contested && nodes_.normal[slot] == normal &&
      nodes_.frame(slot) == frame)
    return;
  changed_in_[slot] = event_;
  const bool in_place = alone(slot);
  if (!vacant(slot) && !in_place) unlink(slot);
  nodes_.set(slot, vertex, 0, frame, normal);
  if (in_place)
    alter(local_index_of_[slot]);
  else
    link(slot);
}

bool LiveChart::rewrite(Index slot, const ChartFrame& frame, Rewritten& rewritten) {
  if (!alone(slot)) return false;
  rewritten.slots.push_back(slot);
  if (nodes_.frame(slot) == frame) return true;
  nodes_.set_frame(slot, frame);
  changed_in_[slot] = event_;
  std::uint32_t& altered_in = altered_in_[local_index_of_[slot]];
  if (std::exchange(altered_in, event_) != event_) rewritten.vertices.push_back(nodes_.vertex[slot]);
  return true;
}

void LiveChart::note(const Rewritten& rewritten) {
  computed_.insert(computed_.end(), rewritten.slots.begin(), rewritten.slots.end());
  altered_.insert(altered_.end(), rewritten.vertices.begin(), rewritten.vertices.end());
}

void LiveChart::remove(Index slot) {
  if (slot >= nodes_.size() || vacant(slot)) return;
  unlink(slot);
  removed_.push_back(slot);
}

void LiveChart::assign(const Chart& chart) {
  begin_event(chart.length, chart.closed, -std::numeric_limits<double>::infinity());
  const std::vector<Index> slots = kept_slots(chart);
  std::vector<std::uint8_t> kept(nodes_.size());
  for (const Index slot : slots)
    if (slot != no_index) kept[slot] = 1;
  for (Index slot = 0; slot < kept.size(); ++slot)
    if (!kept[slot]) remove(slot);
  Index free = 0;
  for (Index i = 0; i < chart.size(); ++i) {
    while (free < states_.size() && !vacant(free)) ++free;
    set(slots[i] == no_index ? free : slots[i], chart.vertex[i], chart.frame(i), chart.normal[i]);
  }
}

/// For each node of a chart, the slot of the node that its vertex already has on the same sheet; no_index
/// when it has none.
std::vector<Index> LiveChart::kept_slots(const Chart& chart) const {
  std::vector<Index> slots(chart.size());
  Index next = no_index;
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (chart.sheet[i] == 0) next = first(chart.vertex[i]);
    slots[i] = next;
    if (next != no_index) next = next_[next];
  }
  return slots;
}

std::vector<Index> LiveChart::sorted_slots() const {
  Index vertex_end = 0;
  for (Index local = 0; local < local_indices_.size(); ++local)
    vertex_end = std::max(vertex_end, local_indices_.vertex(local) + 1);
  IndexSet occupied(vertex_end);
  for (Index local = 0; local < local_indices_.size(); ++local)
    if (first_[local] != no_index) occupied.insert(local_indices_.vertex(local));
  std::vector<Index> vertices;
  occupied.drain(vertices);
  std::vector<Index> slots;
  slots.reserve(nodes_.size());
  for (const Index vertex : vertices)
    for (Index slot = first(vertex); slot != no_index; slot = next_[slot]) slots.push_back(slot);
  return slots;
}

Chart LiveChart::chart_of(std::span<const Index> slots) const {
  Chart chart;
  chart.length = nodes_.length;
  chart.closed = nodes_.closed;
  chart.resize(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Index slot = slots[i];
    chart.set(i, nodes_.vertex[slot], nodes_.sheet[slot], nodes_.frame(slot), nodes_.normal[slot]);
  }
  return chart;
}

void LiveChart::reserve(Index slots) {
  if (slots <= nodes_.size()) return;
  nodes_.resize(slots);
  states_.resize(slots, SlotState::vacant);
  local_index_of_.resize(slots);
  next_.resize(slots);
  changed_in_.resize(slots);
  contested_.resize(slots);
}

/// Inserts the slot into its vertex's list, which is in order, and renumbers the sheets after it.
void LiveChart::link(Index slot) {
  const Index vertex = nodes_.vertex[slot];
  Index local = local_indices_.find(vertex);
  if (local == no_index) {
    local = local_indices_.insert(vertex);
    first_.push_back(no_index);
    altered_in_.push_back(0);
  }
  local_index_of_[slot] = local;
  alter(local);
  std::uint32_t sheet = 0;
  Index* from = &first_[local];
  for (; *from != no_index && is_sheet_before(nodes_, *from, slot); from = &next_[*from]) ++sheet;
  next_[slot] = std::exchange(*from, slot);
  for (Index later = slot; later != no_index; later = next_[later]) nodes_.sheet[later] = sheet++;
  mark_alone(local);
}

void LiveChart::unlink(Index slot) {
  const Index local = local_index_of_[slot];
  alter(local);
  Index* from = &first_[local];
  while (*from != slot) from = &next_[*from];
  *from = next_[slot];
  for (Index later = *from; later != no_index; later = next_[later]) --nodes_.sheet[later];
  states_[slot] = SlotState::vacant;
  mark_alone(local);
}

/// Updates the state of all slots of one vertex: alone, or beside others.
void LiveChart::mark_alone(Index local) {
  const Index first = first_[local];
  const bool alone = first != no_index && next_[first] == no_index;
  for (Index slot = first; slot != no_index; slot = next_[slot])
    states_[slot] = alone ? SlotState::alone : SlotState::beside_others;
}

void LiveChart::alter(Index local) {
  if (altered_in_[local] == event_) return;
  altered_in_[local] = event_;
  altered_.push_back(local_indices_.vertex(local));
}

}  // namespace burin
