#include <burin/chart/chart_nodes.h>

#include <algorithm>

namespace burin {

void ChartNodes::restart(VertexRange own) {
  own_ = own;
  nodes_.clear();
  foreign_.clear();
  least_changed_.clear();
  epoch_ = 0;
  count_ = 0;
}

void ChartNodes::samples_changed(Index first_changed) {
  count_ = samples_->size();
  closed_ = samples_->closed();
  for (auto before = least_changed_.rbegin(); before != least_changed_.rend() && *before > first_changed;
       ++before)
    *before = first_changed;
  least_changed_.push_back(first_changed);
  ++epoch_;
}

Index ChartNodes::first_foreign(Index vertex) const {
  const auto found = foreign_.find(vertex);
  return found == foreign_.end() ? no_index : found->second;
}

bool ChartNodes::found_to_hold(FrontNode& node, Index sample) const {
  if (node.run_epoch != epoch_) forget_changed(node);
  return steps_from(node.run_begin, sample) < node.run_length || extends_to(node, sample);
}

Index ChartNodes::find_or_add(Index vertex, Index sample, Index head) {
  for (Index node = head; node != no_index; node = nodes_[node].next)
    if (holds(node, sample)) return node;
  return add(vertex, sample, head);
}

Index ChartNodes::add(Index vertex, Index sample, Index head) {
  if (head == no_index && own_.holds(vertex)) head = add_block(vertex);
  const GroundPlace place = (*ground_)[vertex];
  if (!samples_->disc_holds(sample, place.position, place.normal)) return no_index;
  Index node = head;
  while (node != no_index && nodes_[node].run_length > 0) node = nodes_[node].next;
  if (node == no_index) node = add_loose(vertex);
  begin_run(nodes_[node], place, sample);
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
}

void ChartNodes::put(FrontNode& node, const GroundPlace& place) {
  node.position = place.position;
  node.normal = place.normal;
  node.gauss = place.gauss_curvature;
}

void ChartNodes::begin_run(FrontNode& node, const GroundPlace& place, Index sample) const {
  put(node, place);
  node.run_begin = sample;
  node.run_length = 1;
  node.run_begins = node.run_ends = false;
  node.run_epoch = epoch_;
  node.state = NodeState::open;
  node.set_g(unreached);
  node.arm_count = 0;
  node.stale = false;
}

void ChartNodes::forget_changed(FrontNode& node) const {
  const Index changed = least_changed_[node.run_epoch];
  node.run_epoch = epoch_;
  if (node.run_begin >= changed) {
    node.run_length = 0;
    node.run_begins = node.run_ends = true;
  } else if (node.run_begin + node.run_length >= changed) {
    node.run_length = changed - node.run_begin;
    node.run_ends = false;
  }
}

bool ChartNodes::extends_to(FrontNode& node, Index sample) const {
  if (closed_) return extends_forward(node, sample) || extends_backward(node, sample);
  return sample < node.run_begin ? extends_backward(node, sample) : extends_forward(node, sample);
}

bool ChartNodes::extends_forward(FrontNode& node, Index sample) const {
  while (!node.run_ends) {
    Index next = node.run_begin + node.run_length;
    if (closed_ && next >= count_) next -= count_;
    if (next == count_) return false;
    node.run_ends = !in_disc(node, next) || (closed_ && node.run_length == count_);
    if (node.run_ends) return false;
    ++node.run_length;
    if (next == sample) return true;
  }
  return false;
}

bool ChartNodes::extends_backward(FrontNode& node, Index sample) const {
  while (!node.run_begins) {
    if (node.run_begin == 0 && !closed_) return false;
    const Index next = (node.run_begin == 0 ? count_ : node.run_begin) - 1;
    node.run_begins = !in_disc(node, next) || (closed_ && node.run_length == count_);
    if (node.run_begins) return false;
    node.run_begin = next;
    ++node.run_length;
    if (next == sample) return true;
  }
  return false;
}

}  // namespace burin
