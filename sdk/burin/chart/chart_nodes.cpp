#include <burin/chart/chart_nodes.h>

#include <algorithm>

namespace burin {

void ChartNodes::restart(VertexRange own) {
  own_ = own;
  nodes_.clear();
  foreign_.clear();
  least_changed_.clear();
  epoch_ = 0;
  told_by_.clear();
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
  std::vector<Told> told;
  for (std::size_t sample = first_changed; sample < told_by_.size(); ++sample)
    told.insert(told.end(), told_by_[sample].begin(), told_by_[sample].end());
  told_by_.resize(std::min<std::size_t>(told_by_.size(), first_changed));
  told_by_.resize(samples_->size() + 1);
  for (const Told& each : told) part(each, first_changed);
}

/// Looks anew at what a sample told that has changed.
void ChartNodes::part(const Told& told, Index first_changed) {
  FrontNode& node = nodes_[told.node];
  if (node.run_length == 0) return;
  if (told.begin || node.run_begin >= first_changed) {
    vacate(node);
    return note_parted(told.node, node.run_begin);
  }
  const Index end_before = std::min(node.run_begin + node.run_length, first_changed);
  set_visit(told.node, visits_to(node).from(node.run_begin));
  const Index end = std::min(node.run_begin + node.run_length, first_changed);
  if (end != end_before) note_parted(told.node, std::min(end, end_before));
}

void ChartNodes::note_parted(Index node, Index sample) {
  parted_.push_back(node);
  first_parted_ = std::min(first_parted_, sample);
}

void ChartNodes::vacate(FrontNode& node) {
  node.run_length = 0;
  node.run_ends = true;
}

Index ChartNodes::first_foreign(Index vertex) const {
  const auto found = foreign_.find(vertex);
  return found == foreign_.end() ? no_index : found->second;
}

bool ChartNodes::found_to_hold(Index node, Index sample) {
  if (nodes_[node].run_epoch != epoch_) update_visit(node);
  return known_to_hold(nodes_[node], sample);
}

/// Follows the changes of samples since somebody last asked.
void ChartNodes::update_visit(Index index) {
  FrontNode& node = nodes_[index];
  const Index changed = least_changed_[node.run_epoch];
  node.run_epoch = epoch_;
  if (node.run_length == 0) return;
  if (node.run_begin >= changed) return vacate(node);
  // What ends before has been told by samples before, or part() has looked at it.
  if (node.run_ends && node.run_begin + node.run_length < changed) return;
  set_visit(index, visits_to(node).from(node.run_begin));
}

void ChartNodes::set_visit(Index index, const Visit& visit) {
  FrontNode& node = nodes_[index];
  node.run_begin = visit.begin;
  node.run_length = visit.length;
  node.run_ends = visit.ends;
  node.run_epoch = epoch_;
  if (visit.told_by != no_index) told_by_[visit.told_by].push_back({index, false});
}

Index ChartNodes::find_or_add(Index vertex, Index sample, Index head) {
  Index floor = 0;
  for (Index node = head; node != no_index; node = nodes_[node].next) {
    if (holds(node, sample)) return node;
    if (nodes_[node].run_length > 0 && nodes_[node].run_begin < sample)
      floor = std::max(floor, nodes_[node].run_begin);
  }
  return add(vertex, sample, floor, head);
}

Index ChartNodes::add(Index vertex, Index sample, Index floor, Index head) {
  if (head == no_index && own_.holds(vertex)) head = add_block(vertex);
  const GroundPlace place = (*ground_)[vertex];
  const Visits visits(*samples_, place.position, place.normal);
  if (!visits.any(sample)) return no_index;
  Index node = head;
  while (node != no_index && nodes_[node].run_length > 0) node = nodes_[node].next;
  if (node == no_index) node = add_loose(vertex);
  put(nodes_[node], place);
  const Visits::Found found = visits.find(sample, floor);
  begin_visit(node, found.visit);
  if (found.begin_told_by != no_index) told_by_[found.begin_told_by].push_back({node, true});
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
  node.run_ends = true;
}

void ChartNodes::put(FrontNode& node, const GroundPlace& place) {
  node.position = place.position;
  node.normal = place.normal;
  node.gauss = place.gauss_curvature;
}

void ChartNodes::begin_visit(Index index, const Visit& visit) {
  set_visit(index, visit);
  FrontNode& node = nodes_[index];
  node.state = NodeState::open;
  node.set_g(unreached);
  node.arm_count = 0;
  node.stale = false;
}

}  // namespace burin
