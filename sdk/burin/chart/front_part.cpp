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
  const float through = from.g + (to.position - from.position).norm();
  // Edges too short to tell in floats still lead downwind, or Upwind would depend on the order.
  return through > from.g ? through : std::nextafter(from.g, unreached);
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
  stack_.clear();
  border_.clear();
  reported_.clear();
}

void FrontPart::change(const SurfaceCurve& curve, const CurveChange& change) {
  for (const Index node : touched_) nodes_[node].touched = false;
  touched_.clear();
  settled_ = pushes_ = 0;
  nodes_.samples_changed(change.first_sample);
  take_back_from(change);
  const SeededCurve on{curve, stroke_->curvature, stroke_->samples};
  for (const Index node : seeds_.update(on, change.first_segment, nodes_)) take_back(node);
  reach_waiting();
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
  for (const Index neighbour : surface_->neighbours[nodes_[node].vertex]) {
    for (Index around = nodes_.first(neighbour); around != no_index; around = nodes_[around].next)
      visit(around);
  }
}

/// Opens a node and the settled ones downwind of it, all of which then wait to be reached again.
void FrontPart::take_back(Index node) {
  stack_.push_back(node);
  take_back_stacked();
}

void FrontPart::take_back_stacked() {
  while (!stack_.empty()) {
    const Index next = stack_.back();
    stack_.pop_back();
    if (!owns(nodes_[next])) continue;
    touch(next);
    if (nodes_[next].state == NodeState::inside) stack_downwind(next);
    FrontNode& taken = nodes_[next];
    taken.state = NodeState::open;
    taken.g = unreached;
    if (taken.border) border_.push_back(next);
    if (taken.waiting) continue;
    taken.waiting = true;
    waiting_.push_back(next);
  }
}

/// Pushes onto the stack what may depend on a node inside: settled nodes downwind of it, and open ones, which
/// it may have reached.
void FrontPart::stack_downwind(Index node) {
  for_each_around(node, [&](Index around) {
    const FrontNode& other = nodes_[around];
    const bool depends = other.state == NodeState::open ? !other.waiting && other.g < unreached
                                                        : is_upwind(nodes_[node], other);
    if (depends) stack_.push_back(around);
  });
}

void FrontPart::reach_waiting() {
  for (const Index node : waiting_) {
    nodes_[node].waiting = false;
    if (nodes_[node].seed != no_index) reach(node, seeds_[nodes_[node].seed].distance);
    for_each_around(node, [&](Index around) {
      const FrontNode& from = nodes_[around];
      if (from.state == NodeState::inside && leads_to(from, node))
        reach(node, distance_through(from, nodes_[node]));
    });
  }
  waiting_.clear();
}

void FrontPart::reach(Index node, float g) {
  FrontNode& reached = nodes_[node];
  if (g >= reached.g) return;
  reached.g = g;
  queue_.push(g, reached.vertex, node);
  ++pushes_;
}

void FrontPart::advance(float limit) {
  while (!queue_.empty() && queue_.least_g() < limit) {
    const BucketQueue::Entry next = queue_.pop();
    const FrontNode& node = nodes_[next.node];
    if (node.state == NodeState::open && node.g == next.g()) settle(next.node);
  }
}

void FrontPart::settle(Index index) {
  ++settled_;
  touch(index);
  FrontNode& node = nodes_[index];
  const Seed* seed = node.seed == no_index ? nullptr : &seeds_[node.seed];
  node.frame = seed && seed->distance <= node.g ? seed->frame : frame_from_arms(index);
  node.frame.t = stroke_->samples.wrapped(node.frame.t);
  list(index, stroke_->samples.at(node.frame.t));
  node.state = within_stroke(index) ? NodeState::inside : NodeState::outside;
  if (node.state == NodeState::inside) lead_on(index);
}

ChartFrame FrontPart::frame_from_arms(Index index) {
  collect_arms(index);
  const float epsilon = 4 * std::numeric_limits<float>::epsilon() * static_cast<float>(stroke_->radius);
  const double origin = nodes_[upwind_[0]].frame.t;
  arms_.begin(nodes_[index], epsilon);
  for (const Index from : upwind_)
    arms_.add(nodes_[from], stroke_->samples.unwrapped(nodes_[from].frame.t, origin));
  return stroke_->order == 1 ? arms_.first_order() : arms_.second_order();
}

void FrontPart::collect_arms(Index index) {
  const FrontNode& node = nodes_[index];
  upwind_.clear();
  for (const Index neighbour : surface_->neighbours[node.vertex]) {
    const auto first = static_cast<std::ptrdiff_t>(upwind_.size());
    for (Index around = nodes_.first(neighbour); around != no_index; around = nodes_[around].next) {
      const FrontNode& from = nodes_[around];
      if (from.state == NodeState::inside && is_upwind(from, node) && leads_to(from, index))
        upwind_.push_back(around);
    }
    // Of a vertex with several nodes more than one may lead here; sums need an order.
    std::ranges::sort(upwind_.begin() + first, upwind_.end(), {},
                      [this](Index q) { return nodes_[q].frame.t; });
  }
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
         static_cast<double>(node.g) <= 2 * std::max(stroke_->radius, distance) &&
         static_cast<double>(samples.chord(node.sample, node.position)) <= distance + stroke_->radius / 2;
}

/// Reaches the open nodes around a node just settled inside that it leads on to; those downwind that were
/// settled without it are taken back first.
void FrontPart::lead_on(Index index) {
  const Index vertex = nodes_[index].vertex, sample = nodes_[index].sample;
  bool border = false;
  for (const Index neighbour : surface_->neighbours[vertex]) {
    if (!own_.holds(neighbour)) {
      border = true;
      continue;
    }
    const Index found = nodes_.at(neighbour, sample);
    if (found == no_index) continue;
    const FrontNode &from = nodes_[index], &to = nodes_[found];
    if (to.state == NodeState::open)
      reach(found, distance_through(from, to));
    else if (is_upwind(from, to))
      stack_.push_back(found);
  }
  if (border && owns(nodes_[index])) {
    nodes_[index].border = true;
    border_.push_back(index);
  }
  if (stack_.empty()) return;
  take_back_stacked();
  reach_waiting();
}

void FrontPart::receive(std::span<const BorderNode> reports) {
  std::vector<Index> inside;
  for (const BorderNode& report : reports) {
    const Index index = copy_of(report);
    if (index == no_index) continue;
    FrontNode& copy = nodes_[index];
    if (copy.state == NodeState::inside) stack_downwind(index);
    copy.state = report.inside ? NodeState::inside : NodeState::open;
    copy.g = report.inside ? report.g : unreached;
    copy.sample = report.sample;
    copy.frame = report.frame;
    if (report.inside) inside.push_back(index);
  }
  take_back_stacked();
  reach_waiting();
  for (const Index index : inside)
    if (nodes_[index].state == NodeState::inside) lead_on(index);
}

/// The copy of a node of another part; no_index when it is of no interest here.
Index FrontPart::copy_of(const BorderNode& report) {
  const auto own = [this](Index vertex) { return own_.holds(vertex); };
  if (own(report.vertex) || std::ranges::none_of(surface_->neighbours[report.vertex], own)) return no_index;
  return nodes_.at(report.vertex, report.sample);
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
  const BorderNode now{node.vertex, node.sample, inside, node.g, node.frame};
  BorderNode& known =
      reported_.try_emplace(index, BorderNode{node.vertex, node.sample, false, 0, {}}).first->second;
  if (known == now || (!known.inside && !inside)) return;
  if (known.inside && (!inside || known.sample != node.sample)) {
    known.inside = false;
    reports_.push_back(known);
  }
  if (inside) reports_.push_back(now);
  known = now;
}

}  // namespace burin
