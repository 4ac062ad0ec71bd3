// Makes the nodes of a front on demand, and finds the samples of their visits. A visit grows sample by sample
// towards the one that is asked for, and is found whole where the stroke may turn or the vertex has other
// visits. A query costs O(1) if the vertex's first node is known to have the sample.
#include <burin/chart/front/chart_nodes.h>

#include <algorithm>

namespace burin {

void ChartNodes::restart(VertexRange own) {
  own_ = own;
  nodes_.clear();
  foreign_.clear();
  least_changed_.clear();
  epoch_ = 0;
  decided_by_.clear();
  parted_.clear();
  first_parted_ = no_index;
}

void ChartNodes::samples_changed(Index first_changed) {
  for (auto before = least_changed_.rbegin(); before != least_changed_.rend() && *before > first_changed;
       ++before)
    *before = first_changed;
  least_changed_.push_back(first_changed);
  ++epoch_;
  parted_.clear();
  first_parted_ = no_index;
  std::vector<Decision> decisions;
  for (std::size_t sample = first_changed; sample < decided_by_.size(); ++sample)
    decisions.insert(decisions.end(), decided_by_[sample].begin(), decided_by_[sample].end());
  decided_by_.resize(std::min<std::size_t>(decided_by_.size(), first_changed));
  decided_by_.resize(samples_->size() + 1);
  for (const Decision& decision : decisions) part(decision, first_changed);
}

/// Finds the start or the end of a visit again after the sample that decided it has changed.
void ChartNodes::part(const Decision& decision, Index first_changed) {
  FrontNode& node = nodes_[decision.node];
  if (node.run_length == 0 || !node.run_whole) return;
  if (decision.begin || node.run_begin >= first_changed) {
    vacate(node);
    return note_parted(decision.node, node.run_begin);
  }
  const Index end_before = std::min(node.run_begin + node.run_length, first_changed);
  set_visit(decision.node, visits_to(node).from(node.run_begin));
  const Index end = std::min(node.run_begin + node.run_length, first_changed);
  if (end != end_before) note_parted(decision.node, std::min(end, end_before));
}

void ChartNodes::note_parted(Index node, Index sample) {
  parted_.push_back(node);
  first_parted_ = std::min(first_parted_, sample);
}

void ChartNodes::vacate(FrontNode& node) {
  node.run_length = 0;
  node.run_begins = node.run_ends = true;
  node.run_whole = false;
}

Index ChartNodes::first_foreign(Index vertex) const {
  const auto found = foreign_.find(vertex);
  return found == foreign_.end() ? no_index : found->second;
}

bool ChartNodes::found_to_hold(Index index, Index sample) {
  FrontNode& node = nodes_[index];
  if (node.run_epoch != epoch_) forget_changed(index);
  if (known_to_hold(node, sample)) return true;
  return !node.run_whole && extends_to(index, sample);
}

/// Follows the changes of samples since somebody last asked.
void ChartNodes::forget_changed(Index index) {
  FrontNode& node = nodes_[index];
  const Index changed = least_changed_[node.run_epoch], end = node.run_begin + node.run_length;
  node.run_epoch = epoch_;
  if (node.run_length == 0) return;
  if (node.run_begin >= changed) return vacate(node);
  // The end of a visit that ends earlier was decided by earlier samples, or part() has found it again.
  if (node.run_ends && end < changed) return;
  if (node.run_whole) return set_visit(index, visits_to(node).from(node.run_begin));
  node.run_length = std::min(end, changed) - node.run_begin;
  node.run_ends = false;
}

bool ChartNodes::extends_to(Index node, Index sample) {
  if (samples_->closed()) return extends_forward(node, sample) || extends_backward(node, sample);
  return sample < nodes_[node].run_begin ? extends_backward(node, sample) : extends_forward(node, sample);
}

bool ChartNodes::extends_forward(Index index, Index sample) {
  FrontNode& node = nodes_[index];
  const Index count = samples_->size();
  while (!node.run_ends) {
    Index next = node.run_begin + node.run_length;
    if (samples_->closed() && next >= count) next -= count;
    if (next == count) return false;
    if (samples_->may_turn((next == 0 ? count : next) - 1)) {
      find_whole(index);
      return known_to_hold(node, sample);
    }
    node.run_ends = !visits_to(node).any(next) || (samples_->closed() && node.run_length == count);
    if (node.run_ends) return false;
    ++node.run_length;
    if (next == sample) return true;
  }
  return false;
}

bool ChartNodes::extends_backward(Index index, Index sample) {
  FrontNode& node = nodes_[index];
  const Index count = samples_->size();
  while (!node.run_begins) {
    if (node.run_begin == 0 && !samples_->closed()) return false;
    const Index next = (node.run_begin == 0 ? count : node.run_begin) - 1;
    if (samples_->may_turn(next)) {
      find_whole(index);
      return known_to_hold(node, sample);
    }
    node.run_begins = !visits_to(node).any(next) || (samples_->closed() && node.run_length == count);
    if (node.run_begins) return false;
    node.run_begin = next;
    ++node.run_length;
    if (next == sample) return true;
  }
  return false;
}

/// Finds all samples of a visit that has some.
void ChartNodes::find_whole(Index index) {
  FrontNode& node = nodes_[index];
  Index floor = 0;
  for (Index other = first(node.vertex()); other != no_index; other = nodes_[other].next)
    if (nodes_[other].run_whole && nodes_[other].run_begin < node.run_begin)
      floor = std::max(floor, nodes_[other].run_begin);
  const Visits::Found found = visits_to(node).find(node.run_begin, floor);
  node.run_whole = node.run_begins = true;
  set_visit(index, found.visit);
  if (found.begin_decided_by != no_index) decided_by_[found.begin_decided_by].push_back({index, true});
}

void ChartNodes::set_visit(Index index, const Visit& visit) {
  FrontNode& node = nodes_[index];
  node.run_begin = visit.begin;
  node.run_length = visit.length;
  node.run_ends = visit.ends;
  node.run_epoch = epoch_;
  if (visit.decided_by != no_index) decided_by_[visit.decided_by].push_back({index, false});
}

Index ChartNodes::find_or_add(Index vertex, Index sample, Index head) {
  for (Index node = head; node != no_index; node = nodes_[node].next)
    if (holds(node, sample)) return node;
  return add(vertex, sample, head);
}

Index ChartNodes::add(Index vertex, Index sample, Index head) {
  if (head == no_index && own_.holds(vertex)) head = add_block(vertex);
  const GroundVertex place = (*ground_)[vertex];
  if (!samples_->disc_holds(sample, place.position, place.normal)) return no_index;
  Index vacant = no_index;
  bool only = true;
  for (Index node = head; node != no_index; node = nodes_[node].next) {
    if (nodes_[node].run_length > 0)
      only = false;
    else if (vacant == no_index)
      vacant = node;
  }
  const Index node = vacant == no_index ? add_loose(vertex) : vacant;
  put(nodes_[node], place);
  begin_visit(nodes_[node], sample);
  // Of several visits to a vertex no more than one is known in parts, or two might turn out to be one.
  if (!only) find_whole(node);
  return node;
}

/// Returns the node of the vertex.
Index ChartNodes::add_block(Index vertex) {
  const Index block = vertex / block_size, first = size();
  const Index begin = block * block_size, end = std::min(begin + block_size, ground_->vertex_count());
  nodes_.resize(first + end - begin);
  for (Index i = begin; i < end; ++i) set_vertex(nodes_[first + i - begin], i);
  return (block_of_[block] = first) + vertex % block_size;
}

/// A further node, behind the first of its vertex.
Index ChartNodes::add_loose(Index vertex) {
  set_vertex(nodes_.emplace_back(), vertex);
  const Index node = size() - 1;
  Index& link =
      own_.holds(vertex) ? nodes_[first(vertex)].next : foreign_.try_emplace(vertex, no_index).first->second;
  nodes_[node].next = link;
  link = node;
  return node;
}

void ChartNodes::set_vertex(FrontNode& node, Index vertex) const {
  node.key = front_key(unreached, vertex);
  node.run_epoch = epoch_;
  node.run_begins = node.run_ends = true;
  node.run_whole = false;
}

void ChartNodes::put(FrontNode& node, const GroundVertex& place) {
  node.position = place.position;
  node.normal = place.normal;
  node.gauss = place.gauss_curvature;
}

void ChartNodes::begin_visit(FrontNode& node, Index sample) const {
  node.run_begin = sample;
  node.run_length = 1;
  node.run_begins = node.run_ends = node.run_whole = false;
  node.run_epoch = epoch_;
  node.state = NodeState::open;
  node.set_g(unreached);
  node.leader_count = 0;
  node.stale = false;
}

}  // namespace burin
