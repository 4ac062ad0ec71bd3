// Normal coordinates by front propagation over the edge graph [Dijkstra 1959]: the discrete exponential map
// [R. Schmidt, C. Grimm, B. Wyvill, Interactive Decal Compositing with Discrete Exponential Maps, 2006],
// upwind averaging [R. Schmidt, Part-Based Representation and Editing of 3D Surface Models, 2010] and frame
// propagation [R. Schmidt, Stroke Parameterization, 2013, section 3]. A dab of n vertices costs O(n log n).
#include <burin/base/error.h>
#include <burin/chart/dabs/dab.h>
#include <burin/chart/dabs/normal_coordinates.h>
#include <burin/chart/frames/float_rounding.h>
#include <burin/chart/frames/frame_step.h>
#include <burin/chart/vertex_nodes.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace burin {
namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();

struct Node {
  enum class State { open, inside, outside };

  float g = unreached;      ///< graph distance from the centre, object units
  Index parent = no_index;  ///< neighbour from which g was reached
  State state = State::open;
  bool seeded = false;  ///< its frame comes from the centre itself
  GroundVertex place;
  DabFrame frame;
};

struct Entry {
  float g;
  Index vertex;
  bool operator>(const Entry& other) const { return std::pair(g, vertex) > std::pair(other.g, other.vertex); }
};

}  // namespace

struct DabChartBuilder::Dab {
  explicit Dab(const ChartGround& g) : ground(g), index(g.vertex_count()) {}

  void restart(const SurfacePoint& at, const Vec3f& normal_there, const Vec3f& direction,
               const DabOptions& with);
  void seed(Index vertex);
  void propagate();
  void settle(Index node);
  DabFrame frame_from_neighbours(Index node);
  void predict(Index from, Index node);
  void lead_on(Index node);
  void reach(Index node, float g, Index parent);
  Vec3f aligned_e1(const Vec3f& normal_there) const;
  Vec3f normal_at(const SurfacePoint& point) const;
  bool within(const Node& node) const;
  Index node_of(Index vertex);
  DabChart collect() const;

  ChartGround ground;
  DabOptions options;
  Vec3f centre, normal, e1;  ///< position and frame of the dab's centre
  VertexNodes index;
  std::vector<Node> nodes;  ///< [node of index]
  std::vector<DabPrediction> predictions;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
};

void DabChartBuilder::Dab::restart(const SurfacePoint& at, const Vec3f& normal_there, const Vec3f& direction,
                                   const DabOptions& with) {
  index.clear();
  nodes.clear();
  queue = {};
  options = with;
  centre = at.position;
  normal = normal_there;
  e1 = unit_tangent(direction, normal);
  for (const Index corner : at.corners) {
    seed(corner);
    for (const Index vertex : ground.neighbours(corner)) seed(vertex);
  }
}

/// The unit normal at a point, interpolated from its corners.
Vec3f DabChartBuilder::Dab::normal_at(const SurfacePoint& point) const {
  Vec3f sum = Vec3f::Zero();
  for (std::size_t i = 0; i < 3; ++i) sum += point.weights[i] * ground[point.corners[i]].normal;
  const float length = sum.norm();
  return length > 1e-6F ? Vec3f(sum / length) : ground[point.corners[0]].normal;
}

/// Gives a vertex beside the centre its coordinates by one straight step.
void DabChartBuilder::Dab::seed(Index vertex) {
  const Index node = node_of(vertex);
  if (nodes[node].seeded) return;
  const GroundVertex& x = nodes[node].place;
  const auto [step, carried] = step_along_edge(centre, normal, e1, x.position, x.normal);
  nodes[node].seeded = true;
  nodes[node].frame = {step, carried};
  reach(node, (x.position - centre).norm(), no_index);
}

Index DabChartBuilder::Dab::node_of(Index vertex) {
  const Index found = index.find(vertex);
  if (found != no_index) return found;
  nodes.emplace_back().place = ground[vertex];
  return index.insert(vertex);
}

/// Settles vertices by ascending (g, vertex). The upwind neighbours of a vertex are those settled before it.
void DabChartBuilder::Dab::propagate() {
  while (!queue.empty()) {
    const Entry next = queue.top();
    queue.pop();
    const Index node = index.find(next.vertex);
    if (nodes[node].state != Node::State::open || nodes[node].g != next.g) continue;
    settle(node);
    if (nodes[node].state == Node::State::inside) lead_on(node);
  }
}

void DabChartBuilder::Dab::settle(Index node) {
  Node& settled = nodes[node];
  if (!settled.seeded) settled.frame = frame_from_neighbours(node);
  settled.state = within(settled) ? Node::State::inside : Node::State::outside;
}

DabFrame DabChartBuilder::Dab::frame_from_neighbours(Index node) {
  predictions.clear();
  if (options.method == DabMethod::dem) {
    predict(nodes[node].parent, node);
  } else {
    for (const Index neighbour : ground.neighbours(index.vertex(node))) {
      const Index found = index.find(neighbour);
      if (found != no_index && nodes[found].state == Node::State::inside) predict(found, node);
    }
  }
  const float epsilon = float_rounding(static_cast<float>(options.radius));
  const Vec3f& normal_there = nodes[node].place.normal;
  DabFrame frame = upwind_mean(predictions, normal_there, epsilon);
  if (options.method != DabMethod::frame_propagation) frame.e1 = aligned_e1(normal_there);
  return frame;
}

void DabChartBuilder::Dab::predict(Index from, Index node) {
  const GroundVertex &q = nodes[from].place, &x = nodes[node].place;
  const DabFrame& known = nodes[from].frame;
  const auto [step, carried] = step_along_edge(q.position, q.normal, known.e1, x.position, x.normal);
  const float length = (x.position - q.position).norm();
  predictions.push_back({index.vertex(from), nodes[from].g + length, length, {known.at + step, carried}});
}

/// The centre's e1 after the minimal rotation of the centre's normal to a vertex's. An edge expressed in this
/// frame is the edge after the rotation R(q, p) of the discrete exponential map.
Vec3f DabChartBuilder::Dab::aligned_e1(const Vec3f& normal_there) const {
  return unit_tangent(transport(e1, normal, normal_there), normal_there);
}

void DabChartBuilder::Dab::lead_on(Index node) {
  for (const Index neighbour : ground.neighbours(index.vertex(node))) {
    const Index found = node_of(neighbour);
    if (nodes[found].state != Node::State::open) continue;
    const float g = nodes[node].g;
    const float edge = (nodes[found].place.position - nodes[node].place.position).norm();
    // g must rise even along edges that are shorter than the float resolution of g.
    reach(found, std::max(g + edge, std::nextafter(g, unreached)), node);
  }
}

void DabChartBuilder::Dab::reach(Index node, float g, Index parent) {
  if (g >= nodes[node].g) return;
  nodes[node].g = g;
  nodes[node].parent = parent;
  queue.push({g, index.vertex(node)});
}

/// Graph distance is never much longer than geodesic distance: a g above twice the radius means that the
/// coordinates are wrong.
bool DabChartBuilder::Dab::within(const Node& node) const {
  const double distance = node.frame.at.cast<double>().norm();
  return distance <= options.radius && static_cast<double>(node.g) <= 2 * options.radius;
}

DabChart DabChartBuilder::Dab::collect() const {
  std::vector<Index> inside;
  for (Index node = 0; node < nodes.size(); ++node) {
    if (nodes[node].state == Node::State::inside) inside.push_back(node);
  }
  std::ranges::sort(inside, {}, [this](Index node) { return index.vertex(node); });
  DabChart chart;
  for (const Index node : inside) {
    const DabFrame& frame = nodes[node].frame;
    chart.vertex.push_back(index.vertex(node));
    chart.u.push_back(frame.at.x());
    chart.v.push_back(frame.at.y());
    chart.e1.push_back(frame.e1);
    chart.normal.push_back(nodes[node].place.normal);
  }
  return chart;
}

DabChartBuilder::DabChartBuilder(const ChartGround& ground) : dab_(std::make_unique<Dab>(ground)) {}
DabChartBuilder::~DabChartBuilder() = default;
DabChartBuilder::DabChartBuilder(DabChartBuilder&&) noexcept = default;
DabChartBuilder& DabChartBuilder::operator=(DabChartBuilder&&) noexcept = default;

DabChart DabChartBuilder::chart(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options) {
  check(centre, e1, options);
  dab_->restart(centre, dab_->normal_at(centre), e1, options);
  dab_->propagate();
  return dab_->collect();
}

DabChart DabChartBuilder::chart(const SurfacePoint& centre, const Vec3f& normal, const Vec3f& e1,
                                const DabOptions& options) {
  check(centre, e1, options);
  dab_->restart(centre, normal, e1, options);
  dab_->propagate();
  return dab_->collect();
}

void DabChartBuilder::check(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options) const {
  if (!std::isfinite(options.radius) || options.radius <= 0) {
    throw ContractError("a dab's radius must be a finite number above 0");
  }
  if (!e1.allFinite() || e1.isZero(0)) throw ContractError("a dab's direction must be finite and not zero");
  const auto on_surface = [this](Index corner) { return corner < dab_->ground.vertex_count(); };
  if (!std::ranges::all_of(centre.corners, on_surface) || !centre.position.allFinite()) {
    throw ContractError("a dab's centre must lie on the surface");
  }
}

}  // namespace burin
