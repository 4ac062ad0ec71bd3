// Front propagation over the edge graph [Dijkstra 1959], as in section 4 of R. Schmidt, Stroke
// Parameterization, 2013, and its repair after a change of the seeds: the settled vertices whose upwind
// neighbours change are taken back and settled again in the order of a fresh run, in the manner of dynamic
// shortest paths [Ramalingam and Reps 1996]. Since a frame depends on upwind frames only, and every vertex
// downwind of a change is taken back before it would be settled, the repaired frames are those of a fresh
// run.
#include <burin/chart/front_part.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

float distance_through(const FrontNode& from, const FrontNode& to) {
  const float g = from.g(), through = g + (to.position - from.position).norm();
  // Edges too short to tell in floats still lead downwind, or Upwind would depend on the order.
  return through > g ? through : std::nextafter(g, unreached);
}

}  // namespace

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

void FrontPart::change(const SurfaceCurve& curve, const CurveChange& change) {
  for (const Index node : touched_) nodes_[node].touched = false;
  touched_.clear();
  settled_ = pushes_ = 0;
  nodes_.samples_changed(change.first_sample);
  take_back_from(change);
  const SeededCurve on{curve, stroke_->curvature, stroke_->samples};
  for (const Seeds::Change& seed : seeds_.update(on, change.first_segment, nodes_)) follow(seed);
  reach_waiting();
}

/// A settled node keeps its g unless its seed gave it, or gives a lower one.
void FrontPart::follow(const Seeds::Change& change) {
  const FrontNode& node = nodes_[change.node];
  const float g = node.g(), distance = seeds_[node.seed].distance;
  if (node.state == NodeState::open || distance < g || (change.distance_before <= g && distance > g))
    take_back(change.node);
  else if (distance == g)
    make_stale(change.node);
}

/// Takes back the settled nodes whose coordinates lie where the curve has changed.
void FrontPart::take_back_from(const CurveChange& change) {
  const Index first = change.first_sample > 0 ? change.first_sample - 1 : 0;
  for (Index sample = first; sample < of_sample_.size(); ++sample) {
    std::vector<Index> nodes = std::move(of_sample_[sample]);
    of_sample_[sample].clear();
    for (const Index node : nodes) {
      FrontNode& settled = nodes_[node];
      if (!settled.listed || settled.sample != sample) continue;
      settled.listed = false;
      if (settled.frame.t < change.unchanged_t)
        list(node, sample);
      else
        take_back(node);
    }
  }
  of_sample_.resize(stroke_->samples.size());
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

/// Calls `visit` with the nodes of the neighbouring vertices.
template <class Visit>
void FrontPart::for_each_around(Index node, const Visit& visit) const {
  for (const Index neighbour : surface_->neighbours[nodes_[node].vertex()]) {
    for (Index around = nodes_.first(neighbour); around != no_index; around = nodes_[around].next)
      visit(around);
  }
}

/// Opens a node and the settled ones downwind of it, all of which then wait to be reached again.
void FrontPart::take_back(Index node) {
  mark(node);
  take_back_marked();
}

void FrontPart::mark(Index node) {
  FrontNode& marked = nodes_[node];
  if (marked.waiting || !owns(marked)) return;
  marked.waiting = true;
  waiting_.push_back(node);
}

void FrontPart::take_back_marked() {
  for (; taken_back_ < waiting_.size(); ++taken_back_) {
    const Index next = waiting_[taken_back_];
    touch(next);
    if (nodes_[next].state == NodeState::inside) mark_downwind(next);
    FrontNode& taken = nodes_[next];
    taken.state = NodeState::open;
    taken.set_g(unreached);
    taken.arm_count = 0;
    taken.stale = false;
    if (taken.gathered) leave_gathered(next);
    if (taken.border) border_.push_back(next);
  }
}

/// Marks the nodes that have their g from a node inside; those that it only has a say in are to be computed
/// again.
void FrontPart::mark_downwind(Index node) {
  for_each_around(node, [&](Index around) {
    const FrontNode &from = nodes_[node], &other = nodes_[around];
    if (other.waiting || !owns(other) || !is_upwind(from, other) || other.g() == unreached) return;
    if (distance_through(from, other) <= other.g())
      mark(around);
    else
      make_stale(around);
  });
}

void FrontPart::reach_waiting() {
  for (const Index node : waiting_) {
    nodes_[node].waiting = false;
    if (nodes_[node].seed != no_index) reach(node, seeds_[nodes_[node].seed].distance);
    for_each_around(node, [&](Index around) {
      const FrontNode& from = nodes_[around];
      if (from.state == NodeState::inside && leads_to(from, node)) reach_from(around, node);
    });
  }
  waiting_.clear();
  taken_back_ = 0;
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
  const std::uint64_t key = node.key;
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

/// Lets the frame of a node whose g stays be computed again in its turn, if it was, or was about to be.
void FrontPart::make_stale(Index index) {
  FrontNode& node = nodes_[index];
  const bool settled = node.state != NodeState::open;
  if (!node.gathered && (!settled || node.stale)) return;
  if (node.gathered) leave_gathered(index);
  node.stale = settled;
  queue_.push(node.key, index);
  ++pushes_;
}

/// Makes stale what depends on the frame of a node inside.
void FrontPart::make_stale_downwind(Index index) {
  for_each_around(index, [&](Index around) {
    const FrontNode &node = nodes_[index], &other = nodes_[around];
    if (owns(other) && is_upwind(node, other) && leads_to(node, around)) make_stale(around);
  });
}

void FrontPart::leave_gathered(Index node) {
  nodes_[node].gathered = false;
  std::ranges::replace(gathered_, node, no_index);
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

/// The same for a node whose g has not changed. What is downwind of it follows, as far as it differs; where
/// other nodes are led to than before, in the long way.
void FrontPart::settle_again(Index index, const ChartFrame& frame) {
  FrontNode& node = nodes_[index];
  node.stale = false;
  if (frame == node.frame) return;
  node.frame = frame;
  const NodeState state = stroke_->samples.at(frame.t) != node.sample ? NodeState::open
                          : within_stroke(index)                      ? NodeState::inside
                                                                      : NodeState::outside;
  if (state != node.state) {
    take_back(index);
    return reach_waiting();
  }
  if (node.border) border_.push_back(index);
  if (state == NodeState::inside) make_stale_downwind(index);
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
  for (const Index neighbour : surface_->neighbours[vertex]) {
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

void FrontPart::receive(std::size_t part, std::span<const BorderNode> reports) {
  std::vector<Index> inside;
  for (const BorderNode& report : reports) {
    const Index index = copy_of(part, report);
    if (index == no_index) continue;
    FrontNode& copy = nodes_[index];
    if (copy.state == NodeState::inside) mark_downwind(index);
    copy.state = report.inside ? NodeState::inside : NodeState::open;
    copy.set_g(report.inside ? report.g : unreached);
    copy.sample = report.sample;
    copy.frame = report.frame;
    if (report.inside) inside.push_back(index);
  }
  take_back_marked();
  for (const Index index : inside)
    if (nodes_[index].state == NodeState::inside) lead_on(index);
  take_back_marked();
  reach_waiting();
}

/// The copy of a node of another part; no_index when it is of no interest here.
Index FrontPart::copy_of(std::size_t part, const BorderNode& report) {
  if (copies_.size() <= part) copies_.resize(part + 1);
  const auto known = copies_[part].find(report.node);
  if (known != copies_[part].end()) return known->second;
  const auto own = [this](Index vertex) { return own_.holds(vertex); };
  if (std::ranges::none_of(surface_->neighbours[report.vertex], own)) return no_index;
  return copies_[part][report.node] = nodes_.add_foreign(report.vertex);
}

std::span<const BorderNode> FrontPart::reports() {
  reports_.clear();
  for (const Index node : border_) report(node);
  border_.clear();
  return reports_;
}

void FrontPart::report(Index index) {
  const FrontNode& node = nodes_[index];
  const bool inside = node.state == NodeState::inside;
  const BorderNode now{index, node.vertex(), node.sample, inside, node.g(), node.frame};
  BorderNode& known = reported_.try_emplace(index, BorderNode{}).first->second;
  if (known == now || (!known.inside && !inside)) return;
  known = now;
  reports_.push_back(now);
}

}  // namespace burin
