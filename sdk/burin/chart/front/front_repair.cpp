// What follows from a change: the settled nodes that have their distance from what changed are taken back and
// settled again in the order of a fresh run, in the manner of dynamic shortest paths [Ramalingam and Reps
// 1996]; those that only have a frame from there are computed again in place. Since a frame depends on
// upwind frames only, and whatever is downwind of a change has its turn after it, the repaired frames are
// those of a fresh run.
#include <burin/chart/front/front_part.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <utility>

namespace burin {

void FrontPart::change(const CurveChange& change) {
  for (const Index node : touched_) nodes_[node].touched = false;
  touched_.clear();
  settled_ = pushes_ = 0;
  nodes_.samples_changed(change.first_sample);
  take_back_from(change);
  for (const Index node : nodes_.parted()) take_back(node);
  const std::size_t first_segment = std::min(change.first_segment, first_parted_segment());
  for (const Seeds::Change& seed : seeds_.update(*stroke_, first_segment, nodes_)) follow_seed(seed);
  reach_waiting();
  for (const Index node : nodes_.parted()) reach_visits_beside(node);
}

std::size_t FrontPart::first_parted_segment() const {
  const SurfaceCurve& curve = stroke_->curve;
  const Index sample = nodes_.first_parted();
  // A shorter stroke than before may not have it any more.
  if (sample > stroke_->samples.size()) return curve.segment_count();
  const double from = sample > 0 ? stroke_->samples.t(sample - 1) : 0;
  return first_ending_from(curve, segment_at(curve, from), from);
}

void FrontPart::reach_visits_beside(Index node) {
  const Index vertex = nodes_[node].vertex();
  for_each_around(node, [&](Index around) {
    // A copy may be of a stroke that was longer, and its own part has not told yet.
    if (nodes_[around].state != NodeState::inside || nodes_[around].sample >= stroke_->samples.size()) return;
    const Index visit = nodes_.at(vertex, nodes_[around].sample);
    if (visit != no_index && nodes_[visit].state == NodeState::open)
      reach_from(around, Leader(nodes_[around], stroke_->path), visit);
  });
}

void FrontPart::follow_seed(const Seeds::Change& change) {
  const FrontNode& node = nodes_[change.node];
  const float g = node.g(), distance = seeds_[node.seed].distance;
  if (node.state == NodeState::open || distance < g || (change.distance_before <= g && distance > g))
    take_back(change.node);
  else if (seed_holds(distance, g) || seed_holds(change.distance_before, g))
    make_stale(change.node);
}

void FrontPart::take_back_from(const CurveChange& change) {
  const Index before_changed = change.first_sample > 0 ? change.first_sample - 1 : 0;
  const Index first = std::min(before_changed, stroke_->samples.at(change.unchanged_t));
  std::vector<Index> unchanged;
  for (Index sample = first; sample < of_sample_.size(); ++sample) {
    std::vector<Index> nodes = std::move(of_sample_[sample]);
    of_sample_[sample].clear();
    for (const Index node : nodes) {
      FrontNode& settled = nodes_[node];
      if (!settled.listed || settled.listed_at != sample) continue;
      settled.listed = false;
      if (static_cast<double>(settled.depends_to) < change.unchanged_t)
        unchanged.push_back(node);
      else
        take_back(node);
    }
  }
  of_sample_.resize(stroke_->samples.size());
  for (const Index node : unchanged) list(node);
}

void FrontPart::take_back(Index node) {
  mark(node);
  take_back_marked();
}

void FrontPart::mark(Index node) {
  FrontNode& marked = nodes_[node];
  if (marked.waiting || !owns(marked)) return;
  marked.mark();
  waiting_.push_back(node);
}

void FrontPart::take_back_marked() {
  for (; taken_back_ < waiting_.size(); ++taken_back_) {
    const Index next = waiting_[taken_back_];
    touch(next);
    if (nodes_[next].state == NodeState::inside) mark_downwind(next);
    FrontNode& taken = nodes_[next];
    if (taken.gathered) leave_gathered(next);
    taken.take_back();
    if (taken.border) border_.push_back(next);
  }
}

void FrontPart::mark_downwind(Index node) {
  const Leader leader(nodes_[node], stroke_->path);
  for_each_around(node, [&](Index around) {
    const FrontNode &from = nodes_[node], &other = nodes_[around];
    if (other.waiting || !owns(other) || !is_upwind(from, other) || other.g() == unreached) return;
    if (leader.may_reach(other.position, other.g()) && leader.to(other.position).g <= other.g())
      mark(around);
    else
      make_stale(around);
  });
}

void FrontPart::reach_waiting() {
  for (const Index node : waiting_) {
    nodes_[node].release();
    if (nodes_[node].seed != no_index) reach(node, seeds_[nodes_[node].seed].distance);
    for_each_around(node, [&](Index around) {
      const FrontNode& from = nodes_[around];
      if (from.state == NodeState::inside && leads_to(from, node))
        reach_from(around, Leader(from, stroke_->path), node);
    });
  }
  waiting_.clear();
  taken_back_ = 0;
}

void FrontPart::make_stale(Index index) {
  FrontNode& node = nodes_[index];
  if (node.gathered)
    leave_gathered(index);
  else if (node.state != NodeState::open && !node.stale)
    node.make_stale();
  else
    return;
  queue_.push(node.key, index);
  ++pushes_;
}

void FrontPart::leave_gathered(Index node) {
  nodes_[node].leave_gathered();
  std::ranges::replace(gathered_, node, no_index);
}

void FrontPart::settle_again(Index index, const ChartFrame& frame) {
  FrontNode& node = nodes_[index];
  node.settle_again();
  list(index);
  if (frame == node.frame) return;
  const ChartFrame before = std::exchange(node.frame, frame);
  const NodeState state = stroke_->samples.at(frame.t) != node.sample ? NodeState::open
                          : within_stroke(index)                      ? NodeState::inside
                                                                      : NodeState::outside;
  if (state != node.state) {
    // What has its distance from the node has it from the frame before.
    node.frame = before;
    take_back(index);
    return reach_waiting();
  }
  if (state == NodeState::outside) return;
  node.frame = before;
  mark_downwind(index);
  nodes_[index].frame = frame;
  take_back_marked();
  lead_on(index);
  take_back_marked();
  reach_waiting();
}

}  // namespace burin
