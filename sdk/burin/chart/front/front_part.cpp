// Front propagation over the edge graph [Dijkstra 1959], as in section 4 of R. Schmidt, Stroke
// Parameterization, 2013. Nodes are settled in the order of the distance at which the frames upwind of them
// place them. Along the edges of the graph distances are up to 41 % too long, and where fronts of two parts
// of the stroke meet the wrong one would win.
#include <burin/chart/frames/float_rounding.h>
#include <burin/chart/frames/mended_frame.h>
#include <burin/chart/front/front_part.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Nodes inside are within the radius, and within a corner of it where the stroke's width goes on straight
/// beyond its ends. In radii.
constexpr double farthest_g = 1.5;

}  // namespace

void FrontPart::restart(VertexRange own) {
  own_ = own;
  nodes_.restart(own);
  seeds_.restart(own);
  queue_.restart(static_cast<float>(farthest_g * stroke_->radius));
  of_sample_.clear();
  touched_.clear();
  waiting_.clear();
  taken_back_ = 0;
  border_.clear();
  reported_.clear();
  copies_.clear();
  frames_.clear();
  frames_.set(float_rounding(static_cast<float>(stroke_->radius)), stroke_->order, stroke_->path);
}

void FrontPart::list(Index node) {
  FrontNode& listed = nodes_[node];
  const Index sample = stroke_->samples.at(static_cast<double>(listed.depends_to));
  if (listed.listed && listed.listed_at == sample) return;
  of_sample_[sample].push_back(node);
  listed.listed = true;
  listed.listed_at = sample;
}

/// Where the way ends it is held against the stroke.
float FrontPart::dependence(const Leader::Way& way) const {
  // Samples and places of the stroke are no farther apart.
  const double to_next = StrokeSamples::most_spacing(stroke_->radius);
  // What the stroke's curvature was at its begin matters beyond that.
  const bool at_begin = way.least_t < static_cast<double>(way.length);
  const double most = at_begin ? std::max(way.most_t, seen_by_curvature * stroke_->radius) : way.most_t;
  return static_cast<float>(most + to_next);
}

void FrontPart::touch(Index node) {
  if (nodes_[node].touched) return;
  nodes_[node].touched = true;
  touched_.push_back(node);
}

void FrontPart::reach(Index node, float g) {
  FrontNode& reached = nodes_[node];
  if (g >= reached.g()) return;
  reached.reach(g);
  queue_.push(reached.key, node);
  ++pushes_;
}

void FrontPart::reach_from(Index from, const Leader& leader, Index index) {
  FrontNode& node = nodes_[index];
  add_leader(node, from);
  const FrontKey key = node.key;
  const Leader::Way way = leader.to(node.position);
  node.depends_to = std::max(node.depends_to, dependence(way));
  reach(index, way.g);
  if (!node.gathered) return;
  // What was about to be settled without this edge waits again.
  leave_gathered(index);
  if (node.key == key) queue_.push(key, index);
}

void FrontPart::add_leader(FrontNode& node, Index from) {
  const auto known = node.leaders.begin() + std::min<std::size_t>(node.leader_count, FrontNode::most_leaders);
  if (std::find(node.leaders.begin(), known, from) != known) return;
  if (node.leader_count < FrontNode::most_leaders) node.leaders[node.leader_count] = from;
  if (node.leader_count <= FrontNode::most_leaders) ++node.leader_count;
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
  if (node.seed != no_index && seed_holds(seeds_[node.seed].distance, node.g()))
    settle_as_seed(next.node);
  else
    gather(next.node);
}

void FrontPart::gather(Index index) {
  find_upwind(index);
  const double origin = nodes_[upwind_[0]].frame.t;
  FrontNode& node = nodes_[index];
  node.gather();
  gathered_[frames_.size()] = index;
  frames_.add_node(node);
  for (const Index from : upwind_)
    frames_.add_edge(nodes_[from], stroke_->samples.unwrapped(nodes_[from].frame.t, origin));
}

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
  if (node.leader_count <= FrontNode::most_leaders) {
    for (std::size_t i = 0; i < node.leader_count; ++i)
      if (counts(node.leaders[i])) insert(node.leaders[i]);
    return;
  }
  for_each_around(index, [&](Index around) {
    if (counts(around)) insert(around);
  });
}

void FrontPart::settle_gathered() {
  if (frames_.size() == 0) return;
  const UpwindFrames::Result upwind = frames_.compute();
  const std::size_t count = frames_.size();
  frames_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    // Taken back by one before it, a node is waiting in the queue again.
    if (gathered_[i] == no_index) continue;
    FrontNode& node = nodes_[gathered_[i]];
    const GroundVertex vertex{node.position, node.normal, node.gauss};
    const auto [frame, depends_to] = mended_frame(*stroke_, vertex, upwind.frames[i]);
    node.contested = upwind.contested[i] || !(frame == upwind.frames[i]);
    node.depends_to =
        std::max(node.depends_to, static_cast<float>(std::max(depends_to, upwind.depends_to[i])));
    settle(gathered_[i], frame);
  }
}

void FrontPart::settle_as_seed(Index index) {
  nodes_[index].contested = false;
  settle(index, seeds_[nodes_[index].seed].frame);
}

void FrontPart::settle(Index index, ChartFrame frame) {
  ++settled_;
  touch(index);
  FrontNode& node = nodes_[index];
  frame.t = stroke_->samples.wrapped(frame.t);
  node.depends_to =
      std::max(node.depends_to, static_cast<float>(frame.t + StrokeSamples::most_spacing(stroke_->radius)));
  if (node.stale) return settle_again(index, frame);
  node.frame = frame;
  node.sample = stroke_->samples.at(frame.t);
  list(index);
  node.settle(within_stroke(index) ? NodeState::inside : NodeState::outside);
  if (node.state == NodeState::outside) return;
  lead_on(index);
  if (waiting_.empty()) return;
  take_back_marked();
  reach_waiting();
}

bool FrontPart::within_stroke(Index index) {
  const FrontNode& node = nodes_[index];
  const StrokeSamples& samples = stroke_->samples;
  const double t = node.frame.t, d = static_cast<double>(node.frame.d), beyond = stroke_->path.beyond(t);
  const bool extended = beyond > 0 && beyond <= (t < 0 ? stroke_->extensions.begin : stroke_->extensions.end);
  const double distance = extended ? std::abs(d) : stroke_->path.chart_distance(t, d);
  // Coordinates have gone astray whose foot is not in the node's own visit.
  return distance <= samples.half_width(t) && nodes_.holds(index, node.sample);
}

void FrontPart::lead_on(Index index) {
  const Index vertex = nodes_[index].vertex(), sample = nodes_[index].sample;
  const Leader leader(nodes_[index], stroke_->path);
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
      if (!to.waiting) reach_from(index, leader, found);
    } else if (is_upwind(nodes_[index], to)) {
      lead_to_settled(index, leader, found);
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

void FrontPart::lead_to_settled(Index from, const Leader& leader, Index index) {
  FrontNode& node = nodes_[index];
  const Leader::Way way = leader.to(node.position);
  if (way.g < node.g()) return mark(index);
  add_leader(node, from);
  node.depends_to = std::max(node.depends_to, dependence(way));
  make_stale(index);
}

}  // namespace burin
