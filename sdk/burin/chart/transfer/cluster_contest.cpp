// Keeps the set of contested slots up to date. An event costs O(1) for each changed node and its neighbours:
// only slots near a change are examined again.
#include <burin/chart/frames/propagate_frame.h>
#include <burin/chart/transfer/cluster_contest.h>

#include <cmath>
#include <utility>

namespace burin {

template <class Visit>
void ClusterContest::for_each_around(const LiveChart& nodes, Index node, const Visit& visit) const {
  for (const Index around : base_->neighbours()[node])
    for (Index slot = nodes.first(around); slot != no_index; slot = nodes.next(slot)) visit(slot);
}

/// Whether a rival belongs to the slot's visit: among the slots of the same base node this one must be
/// nearest to the rival along the stroke.
bool ClusterContest::is_of_visit(const LiveChart& nodes, Index slot, Index rival) const {
  const std::vector<double>& t = nodes.nodes().t;
  for (Index other = nodes.first(nodes.nodes().vertex[slot]); other != no_index; other = nodes.next(other))
    if (std::abs(t[other] - t[rival]) < std::abs(t[slot] - t[rival])) return false;
  return true;
}

/// Near the stroke, nodes take their frames from the stroke itself rather than from neighbours, so the front
/// does not notice when several parts of the stroke meet.
bool ClusterContest::is_near_stroke(const LiveChart& nodes, Index slot) const {
  constexpr double most_spacings = 3;
  return std::abs(static_cast<double>(nodes.nodes().d[slot])) < most_spacings * base_->spacing();
}

bool ClusterContest::is_contested(const LiveChart& nodes, Index slot) const {
  // Quadratics are too inaccurate when lines of constant d turn by more than this, radians, between base
  // nodes.
  constexpr double most_turn = 0.3;
  const Chart& chart = nodes.nodes();
  const bool turns = std::abs(static_cast<double>(chart.curvature[slot])) * base_->spacing() > most_turn;
  if (turns || nodes.contested(slot)) return true;
  if (!is_near_stroke(nodes, slot)) return false;
  bool jumps = false;
  for_each_around(nodes, chart.vertex[slot], [&](Index rival) {
    constexpr double most_spacings = 4;
    const bool far_along = std::abs(chart.t[rival] - chart.t[slot]) > most_spacings * base_->spacing();
    jumps = jumps || (far_along && is_near_stroke(nodes, rival) && is_of_visit(nodes, slot, rival));
  });
  return jumps;
}

std::span<const Index> ClusterContest::update(const LiveChart& nodes) {
  affected_.clear();
  looked_at_.clear();
  contested_.resize(nodes.nodes().size());
  chosen_.resize(nodes.nodes().size());
  is_looked_at_.resize(nodes.nodes().size());
  was_near_.resize(nodes.nodes().size());
  node_of_.resize(nodes.nodes().size(), no_index);
  for (const Index slot : nodes.removed()) leave(nodes, slot);
  for (const Index slot : nodes.computed()) {
    if (!nodes.changed(slot) || nodes.vacant(slot)) continue;
    leave(nodes, slot);
    look_at(nodes, slot);
    look_around(nodes, nodes.nodes().vertex[slot], is_near_stroke(nodes, slot));
  }
  for (const Index slot : looked_at_) follow(nodes, slot);
  return affected_;
}

void ClusterContest::look_at(const LiveChart& nodes, Index slot) {
  if (is_looked_at_[slot] || nodes.vacant(slot)) return;
  is_looked_at_[slot] = 1;
  looked_at_.push_back(slot);
}

/// Discards the state that a slot had before the event.
void ClusterContest::leave(const LiveChart& nodes, Index slot) {
  const Index node = std::exchange(node_of_[slot], no_index);
  if (node == no_index) return;
  const bool was = std::exchange(contested_[slot], 0) != 0;
  affect_around(nodes, node, was);
  count_ -= was ? 1 : 0;
  look_around(nodes, node, was_near_[slot] != 0);
}

/// Schedules slots for examination after a change at a node: its own, of which another one may be nearest to
/// a rival along the stroke now, and where the change was near the stroke those around it.
void ClusterContest::look_around(const LiveChart& nodes, Index node, bool is_near_stroke) {
  for (Index slot = nodes.first(node); slot != no_index; slot = nodes.next(slot)) look_at(nodes, slot);
  if (!is_near_stroke) return;
  for_each_around(nodes, node, [&](Index around) { look_at(nodes, around); });
}

void ClusterContest::follow(const LiveChart& nodes, Index slot) {
  is_looked_at_[slot] = 0;
  was_near_[slot] = is_near_stroke(nodes, slot);
  const Index node = nodes.nodes().vertex[slot];
  const bool is_new = std::exchange(node_of_[slot], node) == no_index;
  const bool now = is_contested(nodes, slot), was = std::exchange(contested_[slot], now) != 0;
  count_ = count_ + (now ? 1 : 0) - (was ? 1 : 0);
  if (is_new || now != was) affect_around(nodes, node, now || was);
}

/// Reports the slots that a change at the node affects: its other visits, whose rivals may differ now, and
/// around it all slots, or without `all` only those that had rivals.
void ClusterContest::affect_around(const LiveChart& nodes, Index node, bool all) {
  if (count_ == 0 && !all) return;
  for (Index slot = nodes.first(node); slot != no_index; slot = nodes.next(slot)) affected_.push_back(slot);
  for_each_around(nodes, node, [&](Index slot) {
    if (all || contested_[slot] || chosen_[slot]) affected_.push_back(slot);
  });
}

void ClusterContest::find_rivals(const LiveChart& nodes, Index slot, std::vector<Index>& rivals) {
  rivals.clear();
  chosen_[slot] = 0;
  if (!any()) return;
  rivals.push_back(slot);
  for_each_around(nodes, nodes.nodes().vertex[slot], [&](Index rival) {
    if ((contested_[slot] || contested_[rival]) && is_of_visit(nodes, slot, rival)) rivals.push_back(rival);
  });
  chosen_[slot] = rivals.size() > 1 || contested_[slot];
  if (!chosen_[slot]) rivals.clear();
}

ChartFrame ClusterContest::extrapolate(const LiveChart& nodes, const StrokePath& path, Index slot,
                                       const GroundVertex& place) const {
  const BasePatch patch = base_->patch(nodes.nodes().vertex[slot]);
  const ChartFrame frame = nodes.nodes().frame(slot);
  const FrameStep step =
      step_along_edge(patch.position, patch.normal, frame.e1, place.position, place.normal);
  const float gauss = (patch.gauss_curvature() + place.gauss_curvature) / 2;
  return propagate_frame(frame, path.ray(frame.t, static_cast<double>(frame.d)), step, place.normal, gauss);
}

}  // namespace burin
