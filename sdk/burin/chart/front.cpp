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
namespace {

bool same_for_charts(const CurvePoint& a, const CurvePoint& b) {
  return a.at.corners == b.at.corners && a.at.position == b.at.position && a.normal == b.normal &&
         a.tangent == b.tangent && a.t == b.t && a.width == b.width;
}

/// Samples and points of a stroke are no finer than this share of the surface.
constexpr double finest_share = 1e-5;

}  // namespace

void Front::restart(double radius, int order, const Extensions& extensions) {
  radius_ = radius;
  order_ = order;
  extensions_ = extensions;
  points_.clear();
  samples_.clear();
  chart_nodes_.clear();
  nodes_.clear();
  seeds_.clear();
  inside_.clear();
  waiting_.clear();
  stack_.clear();
  queue_ = {};
}

void Front::update(const SurfaceCurve& curve) {
  settled_.clear();
  replace_curve(curve);
  replace_seeds(seed_finder_.find(curve, curvature_, samples_, chart_nodes_));
  reach_waiting();
  propagate();
  list_inside();
}

/// Takes back what may be other than before because of the samples: nodes whose run has gone, and those from
/// the first changed sample on.
void Front::replace_curve(const SurfaceCurve& curve) {
  if (curve.closed || samples_.closed()) restart(radius_, order_, extensions_);
  const auto differ = std::ranges::mismatch(points_, curve.points, same_for_charts);
  const auto unchanged = static_cast<std::size_t>(differ.in1 - points_.begin());
  points_.resize(unchanged);
  points_.insert(points_.end(), differ.in2, curve.points.end());

  curvature_.update(curve, curvature_window * radius_, unchanged);
  const Index changed = samples_.update(curve, radius_, finest_share * surface_->scale, extensions_);
  chart_nodes_.update(samples_, changed);
  const double unchanged_t = changed > 0 ? samples_.t(changed - 1) : -std::numeric_limits<double>::infinity();
  for (Index node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].state == State::open) continue;
    if (nodes_[node].frame.t >= unchanged_t || chart_nodes_.vacant(node)) take_back(node);
  }
}

void Front::replace_seeds(std::span<const Seed> seeds) {
  nodes_.resize(chart_nodes_.size());
  std::vector<Index> before = std::move(seeds_);
  seeds_.clear();
  for (const Seed& seed : seeds) {
    nodes_[seed.node].seeded = true;
    seeds_.push_back(seed.node);
    set_seed(seed.node, seed.distance, seed.frame);
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

/// Calls `visit` with the nodes of the neighbouring vertices.
template <class Visit>
void Front::for_each_around(Index node, const Visit& visit) const {
  for (const Index neighbour : surface_->neighbours[vertex(node)]) {
    for (Index around = chart_nodes_.first(neighbour); around != no_index; around = chart_nodes_.next(around))
      visit(around);
  }
}

/// Opens a node and the settled ones downwind of it, all of which then wait to be reached again.
void Front::take_back(Index node) {
  stack_.push_back(node);
  while (!stack_.empty()) {
    const Index next = stack_.back();
    stack_.pop_back();
    Node& taken = nodes_[next];
    if (taken.state == State::inside) take_back_downwind(next);
    taken.state = State::open;
    taken.g = unreached;
    taken.listed = false;
    if (taken.waiting) continue;
    taken.waiting = true;
    waiting_.push_back(next);
  }
}

/// Pushes onto the stack what may depend on a node inside: settled nodes downwind of it, and open ones, which
/// it may have reached.
void Front::take_back_downwind(Index node) {
  for_each_around(node, [&](Index around) {
    const bool open = nodes_[around].state == State::open;
    if (open ? !nodes_[around].waiting : is_upwind(node, around)) stack_.push_back(around);
  });
}

void Front::reach_waiting() {
  for (const Index node : waiting_) {
    nodes_[node].waiting = false;
    if (nodes_[node].seed_distance < unreached) reach(node, nodes_[node].seed_distance);
    for_each_around(node, [&](Index around) {
      if (nodes_[around].state == State::inside && leads_to(around, node))
        reach(node, distance_through(around, node));
    });
  }
  waiting_.clear();
}

void Front::propagate() {
  while (!queue_.empty()) {
    const auto [g, vertex, node] = queue_.top();
    queue_.pop();
    if (nodes_[node].state != State::open || nodes_[node].g != g) continue;
    settle(node);
    if (nodes_[node].state == State::inside) lead_on(node);
  }
}

void Front::settle(Index node) {
  Node& settled = nodes_[node];
  settled.frame = settled.seed_distance <= settled.g ? settled.seed : frame_from_arms(node);
  settled.frame.t = samples_.wrapped(settled.frame.t);
  settled.state = within_stroke(node) ? State::inside : State::outside;
  settled_.push_back(node);
}

ChartFrame Front::frame_from_arms(Index node) {
  collect_arms(node);
  keep_agreeing(arms_);
  const Vec3f& normal = surface_->normals[vertex(node)];
  const float epsilon = 4 * std::numeric_limits<float>::epsilon() * static_cast<float>(radius_);
  return order_ == 1 ? first_order_frame(arms_, normal, epsilon) : second_order_frame(arms_, normal, epsilon);
}

void Front::collect_arms(Index node) {
  arms_.clear();
  const Vec3f &x = surface_->positions[vertex(node)], &normal = surface_->normals[vertex(node)];
  const float gauss = surface_->gauss_curvature[vertex(node)];
  for_each_around(node, [&](Index around) {
    if (nodes_[around].state != State::inside || !is_upwind(around, node) || !leads_to(around, node)) return;
    const Index from = vertex(around);
    const Vec3f& q = surface_->positions[from];
    const ChartFrame& frame = nodes_[around].frame;
    arms_.push_back({from, frame, step_along_edge(q, surface_->normals[from], frame.e1, x, normal),
                     (x - q).norm(), (gauss + surface_->gauss_curvature[from]) / 2});
  });
  // Of a vertex with several nodes more than one may lead here; sums need an order.
  std::ranges::sort(arms_, {}, [](const UpwindArm& arm) { return std::pair(arm.from, arm.frame.t); });
  for (UpwindArm& arm : arms_) arm.frame.t = samples_.unwrapped(arm.frame.t, arms_[0].frame.t);
}

/// Reaches the open nodes around a node just settled inside that it leads on to; those downwind that were
/// settled without it are taken back first.
void Front::lead_on(Index node) {
  const Index sample = samples_.at(nodes_[node].frame.t);
  ahead_.clear();
  for (const Index neighbour : surface_->neighbours[vertex(node)]) {
    const Index found = chart_nodes_.at(samples_, neighbour, sample);
    if (found == no_index) continue;
    if (found >= nodes_.size()) nodes_.resize(found + 1);
    ahead_.push_back(found);
    if (nodes_[found].state != State::open && is_upwind(node, found)) take_back(found);
  }
  reach_waiting();
  for (const Index found : ahead_) {
    if (nodes_[found].state == State::open) reach(found, distance_through(node, found));
  }
}

void Front::reach(Index node, float g) {
  if (g >= nodes_[node].g) return;
  nodes_[node].g = g;
  queue_.push({g, vertex(node), node});
}

bool Front::leads_to(Index from, Index to) const {
  return chart_nodes_.holds(to, samples_.at(nodes_[from].frame.t));
}

bool Front::is_upwind(Index a, Index b) const {
  return std::pair(nodes_[a].g, vertex(a)) < std::pair(nodes_[b].g, vertex(b));
}

float Front::distance_through(Index from, Index to) const {
  const float g = nodes_[from].g;
  const float edge = (surface_->positions[vertex(to)] - surface_->positions[vertex(from)]).norm();
  // Edges too short to tell in floats still lead downwind, or Upwind would depend on the order.
  return std::max(g + edge, std::nextafter(g, unreached));
}

bool Front::within_stroke(Index node) const {
  const Node& settled = nodes_[node];
  const double t = settled.frame.t, d = std::abs(static_cast<double>(settled.frame.d));
  const double beyond = samples_.closed() ? 0 : std::max({-t, t - samples_.length(), 0.});
  const double distance = std::hypot(beyond, d);
  const bool extended = beyond > 0 && beyond <= (t < 0 ? extensions_.begin : extensions_.end);
  if (!((extended ? d : distance) <= samples_.half_width(t))) return false;
  // Coordinates have gone astray whose foot is not in the node's own visit, is farther off on the straight
  // line than it should be on the surface, or was reached on a way much longer than a geodesic.
  const Index foot = samples_.at(t);
  return chart_nodes_.holds(node, foot) &&
         static_cast<double>(settled.g) <= 2 * std::max(radius_, distance) &&
         static_cast<double>(samples_.chord(foot, surface_->positions[vertex(node)])) <=
             distance + radius_ / 2;
}

void Front::list_inside() {
  const auto earlier = [this](Index a, Index b) {
    return std::pair(vertex(a), chart_nodes_.begin(a)) < std::pair(vertex(b), chart_nodes_.begin(b));
  };
  std::erase_if(inside_, [this](Index node) { return !nodes_[node].listed; });
  std::vector<Index> joined;
  for (const Index node : settled_) {
    if (nodes_[node].state != State::inside || nodes_[node].listed) continue;
    nodes_[node].listed = true;
    joined.push_back(node);
  }
  std::ranges::sort(joined, earlier);
  std::vector<Index> merged;
  merged.reserve(inside_.size() + joined.size());
  std::ranges::merge(inside_, joined, std::back_inserter(merged), earlier);
  inside_ = std::move(merged);
}

}  // namespace burin
