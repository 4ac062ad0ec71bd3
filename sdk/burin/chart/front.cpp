// Front propagation over the edge graph [Dijkstra 1959], as in section 4 of R. Schmidt, Stroke
// Parameterization, 2013, and its repair after a change of the seeds: the settled vertices whose upwind
// neighbours change are taken back and settled again in the order of a fresh run, in the manner of dynamic
// shortest paths [Ramalingam and Reps 1996]. Since a frame depends on upwind frames only, and every vertex
// downwind of a change is taken back before it would be settled, the repaired frames are those of a fresh
// run.
#include <burin/chart/frame_step.h>
#include <burin/chart/front.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {

void Front::restart(double radius, int order) {
  radius_ = radius;
  order_ = order;
  length_ = 0;
  index_.clear();
  nodes_.clear();
  seeds_.clear();
  inside_.clear();
  waiting_.clear();
  stack_.clear();
  queue_ = {};
}

void Front::update(std::span<const Seed> seeds, double length) {
  settled_.clear();
  replace_length(length);
  replace_seeds(seeds);
  reach_waiting();
  propagate();
  list_inside();
}

Index Front::node_of(Index vertex) {
  const Index found = index_.find(vertex);
  if (found != no_index) return found;
  nodes_.emplace_back();
  return index_.insert(vertex);
}

void Front::replace_seeds(std::span<const Seed> seeds) {
  std::vector<Index> before = std::move(seeds_);
  seeds_.clear();
  for (const Seed& seed : seeds) {
    const Index node = node_of(seed.vertex);
    nodes_[node].seeded = true;
    seeds_.push_back(node);
    set_seed(node, seed.distance, seed.frame);
  }
  for (const Index node : before) {
    if (!nodes_[node].seeded) set_seed(node, unreached, {});
  }
  for (const Index node : seeds_) nodes_[node].seeded = false;
}

void Front::set_seed(Index node, float distance, const ChartFrame& seed) {
  Node& changed = nodes_[node];
  if (changed.seed_distance == distance && changed.seed == seed) return;
  changed.seed_distance = distance;
  changed.seed = seed;
  take_back(node);
}

/// Beyond the shorter of the two ends other vertices may be within the stroke.
void Front::replace_length(double length) {
  const double end = std::min(length_, length);
  length_ = length;
  for (Index node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].state != State::open && nodes_[node].frame.t > end) take_back(node);
  }
}

/// Opens a vertex and the settled ones downwind of it, all of which then wait to be reached again.
void Front::take_back(Index node) {
  stack_.push_back(node);
  while (!stack_.empty()) {
    const Index next = stack_.back();
    stack_.pop_back();
    Node& taken = nodes_[next];
    const bool led_on = taken.state == State::inside;
    if (led_on) take_back_downwind(next);
    taken.state = State::open;
    taken.g = unreached;
    if (taken.waiting) continue;
    taken.waiting = true;
    waiting_.push_back(next);
  }
}

/// Pushes onto the stack what depends on a vertex inside: settled vertices downwind of it, and open ones,
/// which it may have reached.
void Front::take_back_downwind(Index node) {
  for (const Index neighbour : surface_->neighbours[index_.vertex(node)]) {
    const Index found = index_.find(neighbour);
    if (found == no_index) continue;
    const bool open = nodes_[found].state == State::open;
    if (open ? !nodes_[found].waiting : is_upwind(node, found)) stack_.push_back(found);
  }
}

void Front::reach_waiting() {
  for (const Index node : waiting_) {
    nodes_[node].waiting = false;
    if (nodes_[node].seed_distance < unreached) reach(node, nodes_[node].seed_distance);
    for (const Index neighbour : surface_->neighbours[index_.vertex(node)]) {
      const Index found = index_.find(neighbour);
      if (found == no_index || nodes_[found].state != State::inside) continue;
      reach(node, distance_through(found, node));
    }
  }
  waiting_.clear();
}

void Front::propagate() {
  while (!queue_.empty()) {
    const Entry next = queue_.top();
    queue_.pop();
    const Index node = index_.find(next.vertex);
    if (nodes_[node].state != State::open || nodes_[node].g != next.g) continue;
    settle(node);
    if (nodes_[node].state == State::inside) lead_on(node);
  }
}

void Front::settle(Index node) {
  Node& settled = nodes_[node];
  if (settled.seed_distance <= settled.g) {
    settled.frame = settled.seed;
  } else {
    collect_arms(node);
    const float epsilon = 4 * std::numeric_limits<float>::epsilon() * static_cast<float>(radius_);
    const Vec3f& normal = surface_->normals[index_.vertex(node)];
    keep_agreeing(arms_);
    settled.frame =
        order_ == 1 ? first_order_frame(arms_, normal, epsilon) : second_order_frame(arms_, normal, epsilon);
  }
  settled.state = within_stroke(settled) ? State::inside : State::outside;
  settled_.push_back(node);
}

void Front::collect_arms(Index node) {
  arms_.clear();
  const Index vertex = index_.vertex(node);
  const Vec3f &x = surface_->positions[vertex], &normal = surface_->normals[vertex];
  for (const Index neighbour : surface_->neighbours[vertex]) {
    const Index found = index_.find(neighbour);
    if (found == no_index || nodes_[found].state != State::inside || !is_upwind(found, node)) continue;
    const Vec3f& q = surface_->positions[neighbour];
    const ChartFrame& frame = nodes_[found].frame;
    arms_.push_back({neighbour, frame, step_along_edge(q, surface_->normals[neighbour], frame.e1, x, normal),
                     (x - q).norm(),
                     (surface_->gauss_curvature[vertex] + surface_->gauss_curvature[neighbour]) / 2});
  }
}

/// Reaches the open neighbours of a vertex just settled inside; those downwind that were settled without it
/// are taken back first.
void Front::lead_on(Index node) {
  for (const Index neighbour : surface_->neighbours[index_.vertex(node)]) {
    const Index found = node_of(neighbour);
    if (nodes_[found].state != State::open && is_upwind(node, found)) take_back(found);
  }
  reach_waiting();
  for (const Index neighbour : surface_->neighbours[index_.vertex(node)]) {
    const Index found = index_.find(neighbour);
    if (nodes_[found].state == State::open) reach(found, distance_through(node, found));
  }
}

void Front::reach(Index node, float g) {
  if (g >= nodes_[node].g) return;
  nodes_[node].g = g;
  queue_.push({g, index_.vertex(node)});
}

bool Front::is_upwind(Index a, Index b) const {
  return std::pair(nodes_[a].g, index_.vertex(a)) < std::pair(nodes_[b].g, index_.vertex(b));
}

float Front::distance_through(Index from, Index to) const {
  const float g = nodes_[from].g;
  const float edge =
      (surface_->positions[index_.vertex(to)] - surface_->positions[index_.vertex(from)]).norm();
  // Edges too short to tell in floats still lead downwind, or Upwind would depend on the order.
  return std::max(g + edge, std::nextafter(g, unreached));
}

bool Front::within_stroke(const Node& node) const {
  // The graph distance is never much longer than the geodesic: beyond, the coordinates have gone astray.
  if (static_cast<double>(node.g) > 2 * radius_) return false;
  const double beyond = std::max({-node.frame.t, node.frame.t - length_, 0.});
  return std::hypot(beyond, static_cast<double>(node.frame.d)) <= radius_;
}

void Front::list_inside() {
  const auto by_vertex = [this](Index node) { return index_.vertex(node); };
  std::erase_if(inside_, [this](Index node) {
    nodes_[node].listed = nodes_[node].state == State::inside;
    return !nodes_[node].listed;
  });
  std::vector<Index> joined;
  for (const Index node : settled_) {
    if (nodes_[node].state != State::inside || nodes_[node].listed) continue;
    nodes_[node].listed = true;
    joined.push_back(node);
  }
  std::ranges::sort(joined, {}, by_vertex);
  std::vector<Index> merged;
  merged.reserve(inside_.size() + joined.size());
  std::ranges::merge(inside_, joined, std::back_inserter(merged), {}, by_vertex, by_vertex);
  inside_ = std::move(merged);
}

}  // namespace burin
