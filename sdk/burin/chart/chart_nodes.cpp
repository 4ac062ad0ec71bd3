#include <burin/chart/chart_nodes.h>

#include <algorithm>

namespace burin {

void ChartNodes::clear() {
  first_.clear();
  first_node_.clear();
  nodes_.clear();
}

void ChartNodes::update(const StrokeSamples& samples, Index first_changed) {
  wraps_ = samples.closed();
  for (Node& node : nodes_) {
    if (node.end + 1 < first_changed) continue;
    if (node.begin >= first_changed) {
      node.begin = first_changed + 1;
      node.end = first_changed;  // vacant
      continue;
    }
    node.end = first_changed - 1;
    while (node.end + 1 < samples.size() && in_disc(samples, node.vertex, node.end + 1)) ++node.end;
  }
}

Index ChartNodes::first(Index vertex) const {
  const Index entry = first_.find(vertex);
  return entry == no_index ? no_index : first_node_[entry];
}

Index ChartNodes::at(const StrokeSamples& samples, Index vertex, Index sample) {
  for (Index node = first(vertex); node != no_index; node = next(node)) {
    if (holds(node, sample)) return node;
  }
  if (!in_disc(samples, vertex, sample)) return no_index;
  const Run run = run_around(samples, vertex, sample);
  for (Index node = first(vertex); node != no_index; node = next(node)) {
    if (!vacant(node)) continue;
    nodes_[node].begin = run.begin;
    nodes_[node].end = run.end;
    return node;
  }
  Index entry = first_.find(vertex);
  if (entry == no_index) {
    entry = first_.insert(vertex);
    first_node_.push_back(no_index);
  }
  nodes_.push_back({vertex, run.begin, run.end, first_node_[entry]});
  return first_node_[entry] = size() - 1;
}

ChartNodes::Run ChartNodes::run_around(const StrokeSamples& samples, Index vertex, Index sample) const {
  const Index count = samples.size();
  Run run{sample, sample};
  if (!samples.closed()) {
    while (run.begin > 0 && in_disc(samples, vertex, run.begin - 1)) --run.begin;
    while (run.end + 1 < count && in_disc(samples, vertex, run.end + 1)) ++run.end;
    return run;
  }
  Index length = 1;
  for (; length < count && in_disc(samples, vertex, (run.end + 1) % count); ++length) {
    run.end = (run.end + 1) % count;
  }
  if (length == count) return {0, count - 1};
  while (in_disc(samples, vertex, (run.begin + count - 1) % count)) {
    run.begin = (run.begin + count - 1) % count;
  }
  return run;
}

bool ChartNodes::in_disc(const StrokeSamples& samples, Index vertex, Index sample) const {
  return samples.disc_holds(sample, surface_->positions[vertex], surface_->normals[vertex]);
}

}  // namespace burin
