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

Index ChartNodes::add(Index vertex, Index sample, Index head) {
  const Vec3f &position = surface_->positions[vertex], &normal = surface_->normals[vertex];
  if (!samples_->disc_holds(sample, position, normal)) return no_index;
  for (Index node = head; node != no_index; node = nodes_[node].next) {
    if (nodes_[node].run_length > 0) continue;
    begin_run(nodes_[node], sample);
    return node;
  }
  FrontNode& node = nodes_.emplace_back();
  node.vertex = vertex;
  node.next = head;
  node.position = position;
  node.normal = normal;
  node.gauss = surface_->gauss_curvature[vertex];
  begin_run(node, sample);
  return (own_.holds(vertex) ? heads_[vertex] : foreign_[vertex]) = size() - 1;
}

void ChartNodes::begin_run(FrontNode& node, Index sample) const {
  node.run_begin = sample;
  node.run_length = 1;
  node.run_begins = node.run_ends = false;
  node.run_epoch = epoch_;
  node.state = NodeState::open;
  node.g = unreached;
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
