// Front propagation over the edge graph [Dijkstra 1959], as in section 4 of R. Schmidt, Stroke
// Parameterization, 2013.
#include <burin/chart/front_part.h>

#include <algorithm>
#include <cmath>

namespace burin {

void FrontPart::restart(VertexRange own) {
  own_ = own;
  nodes_.restart(own);
  seeds_.restart(own);
  // Nodes inside have a graph distance of at most twice the radius.
  queue_.restart(static_cast<float>(2.25 * stroke_->radius));
  of_sample_.clear();
  touched_.clear();
  waiting_.clear();
  taken_back_ = 0;
  border_.clear();
  reported_.clear();
  copies_.clear();
  frames_.clear();
  frames_.set(4 * std::numeric_limits<float>::epsilon() * static_cast<float>(stroke_->radius),
              stroke_->order);
}

void FrontPart::list(Index node, Index sample) {
  FrontNode& listed = nodes_[node];
  if (listed.listed && listed.sample == sample) return;
  of_sample_[sample].push_back(node);
  listed.listed = true;
  listed.sample = sample;
}

void FrontPart::touch(Index node) {
  if (nodes_[node].touched) return;
  nodes_[node].touched = true;
  touched_.push_back(node);
}

void FrontPart::reach(Index node, float g) {
  FrontNode& reached = nodes_[node];
  if (g >= reached.g()) return;
  reached.set_g(g);
  queue_.push(reached.key, node);
  ++pushes_;
}

void FrontPart::reach_from(Index from, Index index) {
  FrontNode& node = nodes_[index];
  add_arm(node, from);
  const FrontKey key = node.key;
  reach(index, distance_through(nodes_[from], node));
  if (!node.gathered) return;
  // What was about to be settled without this arm waits again.
  leave_gathered(index);
  if (node.key == key) queue_.push(key, index);
}

void FrontPart::add_arm(FrontNode& node, Index from) {
  const auto known = node.arms.begin() + std::min<std::size_t>(node.arm_count, FrontNode::most_arms);
  if (std::find(node.arms.begin(), known, from) != known) return;
  if (node.arm_count < FrontNode::most_arms) node.arms[node.arm_count] = from;
  if (node.arm_count <= FrontNode::most_arms) ++node.arm_count;
}

/// Nodes are settled several at a time. One that depends on another of these is settled later.
void FrontPart::advance(float limit) {
  const auto goes_on = [&] { return !queue_.empty() && queue_.top().g() < limit; };
  while (goes_on()) {
    while (goes_on() && frames_.size() < UpwindFrames::capacity) settle_or_gather_next();
    settle_gathered();
  }
}

void FrontPart::settle_or_gather_next() {
  const BucketQueue::Entry next = queue_.top();
  queue_.pop();
  const FrontNode& node = nodes_[next.node];
  const bool waits = node.state == NodeState::open || node.stale;
  if (!waits || node.gathered || node.key != next.key) return;
  if (node.seed != no_index && seeds_[node.seed].distance <= node.g())
    settle(next.node, seeds_[node.seed].frame);
  else
    gather(next.node);
}

void FrontPart::gather(Index index) {
  find_upwind(index);
  const double origin = nodes_[upwind_[0]].frame.t;
  FrontNode& node = nodes_[index];
  node.gathered = true;
  gathered_[frames_.size()] = index;
  frames_.add_node(node);
  for (const Index from : upwind_)
    frames_.add_arm(nodes_[from], stroke_->samples.unwrapped(nodes_[from].frame.t, origin));
}

/// Lists the upwind nodes that lead here in the order of vertex and t: sums need an order.
void FrontPart::find_upwind(Index index) {
  const FrontNode& node = nodes_[index];
  upwind_.clear();
  const auto insert = [this](Index q) {
    const auto before = [this](Index a, Index b) {
      const FrontNode &x = nodes_[a], &y = nodes_[b];
      return x.vertex() != y.vertex() ? x.vertex() < y.vertex() : x.frame.t < y.frame.t;
    };
    upwind_.push_back(q);
    for (std::size_t i = upwind_.size() - 1; i > 0 && before(upwind_[i], upwind_[i - 1]); --i)
      std::swap(upwind_[i], upwind_[i - 1]);
  };
  const auto counts = [&](Index around) {
    const FrontNode& from = nodes_[around];
    return from.state == NodeState::inside && is_upwind(from, node) && leads_to(from, index);
  };
  if (node.arm_count <= FrontNode::most_arms) {
    for (std::size_t i = 0; i < node.arm_count; ++i)
      if (counts(node.arms[i])) insert(node.arms[i]);
    return;
  }
  for_each_around(index, [&](Index around) {
    if (counts(around)) insert(around);
  });
}

void FrontPart::settle_gathered() {
  if (frames_.size() == 0) return;
  const std::array<ChartFrame, UpwindFrames::capacity> frames = frames_.compute();
  const std::size_t count = frames_.size();
  frames_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    // Taken back by one before it, a node is waiting in the queue again.
    if (gathered_[i] != no_index) settle(gathered_[i], frames[i]);
  }
}

void FrontPart::settle(Index index, ChartFrame frame) {
  ++settled_;
  touch(index);
  FrontNode& node = nodes_[index];
  node.gathered = false;
  frame.t = stroke_->samples.wrapped(frame.t);
  if (node.stale) return settle_again(index, frame);
  node.frame = frame;
  list(index, stroke_->samples.at(node.frame.t));
  node.state = within_stroke(index) ? NodeState::inside : NodeState::outside;
  if (node.state == NodeState::outside) return;
  lead_on(index);
  if (waiting_.empty()) return;
  take_back_marked();
  reach_waiting();
}

bool FrontPart::within_stroke(Index index) {
  const FrontNode& node = nodes_[index];
  const StrokeSamples& samples = stroke_->samples;
  const double t = node.frame.t, d = std::abs(static_cast<double>(node.frame.d));
  const double beyond = samples.closed() ? 0 : std::max({-t, t - samples.length(), 0.});
  const double distance = beyond > 0 ? std::sqrt(beyond * beyond + d * d) : d;
  const bool extended = beyond > 0 && beyond <= (t < 0 ? stroke_->extensions.begin : stroke_->extensions.end);
  if (!((extended ? d : distance) <= samples.half_width(t))) return false;
  // Coordinates have gone astray whose foot is not in the node's own visit, is farther off on the straight
  // line than it should be on the surface, or was reached on a way much longer than a geodesic.
  return nodes_.holds(index, node.sample) &&
         static_cast<double>(node.g()) <= 2 * std::max(stroke_->radius, distance) &&
         static_cast<double>(samples.chord(node.sample, node.position)) <= distance + stroke_->radius / 2;
}

/// Reaches the open nodes around a node just settled inside that it leads on to, and marks those downwind
/// that were settled without it. Nodes that wait will ask by themselves.
void FrontPart::lead_on(Index index) {
  const Index vertex = nodes_[index].vertex(), sample = nodes_[index].sample;
  bool border = false;
  for (const Index neighbour : ground_->neighbours(vertex)) {
    if (!own_.holds(neighbour)) {
      border = true;
      continue;
    }
    const Index found = nodes_.at(neighbour, sample);
    if (found == no_index) continue;
    const FrontNode& to = nodes_[found];
    if (to.state == NodeState::open) {
      if (!to.waiting) reach_from(index, found);
    } else if (is_upwind(nodes_[index], to)) {
      lead_to_settled(index, found);
    }
  }
  if (border && owns(nodes_[index])) {
    nodes_[index].border = true;
    border_.push_back(index);
  }
}

std::vector<const FrontNode*> FrontPart::inside() {
  std::vector<Index> vertices;
  for (Index node = 0; node < nodes_.size(); ++node)
    if (nodes_[node].state == NodeState::inside && owns(nodes_[node])) inside_.insert(nodes_[node].vertex());
  inside_.drain(vertices);
  std::vector<const FrontNode*> nodes;
  nodes.reserve(vertices.size());
  for (const Index vertex : vertices) {
    const std::size_t first = nodes.size();
    for (Index node = nodes_.first(vertex); node != no_index; node = nodes_[node].next)
      if (nodes_[node].state == NodeState::inside) nodes.push_back(&nodes_[node]);
    if (nodes.size() > first + 1)
      std::ranges::sort(nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end(), {},
                        [](const FrontNode* node) { return node->frame.t; });
  }
  return nodes;
}

/// A node that was settled without an upwind one that leads to it.
void FrontPart::lead_to_settled(Index from, Index index) {
  FrontNode& node = nodes_[index];
  if (distance_through(nodes_[from], node) < node.g()) return mark(index);
  add_arm(node, from);
  make_stale(index);
}

}  // namespace burin
