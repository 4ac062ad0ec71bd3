// Stroke charts by front propagation [R. Schmidt, Stroke Parameterization, 2013].
//
// Dijkstra's algorithm runs over the edge graph from the seeds beside the stroke. Each vertex x, as its graph
// distance g becomes final, takes
//   P(x)  = sum of w (P(q) + T_q(x)) / sum of w                     (Eq. 2)
//   e1(x) = sum of w R(q, x) e1(q), made unit and tangent           (Eq. 3)
// over its upwind neighbours q: those in the chart with (g_q, q) < (g_x, x) in lexicographic order. Weights
// w = 1 / |q - x|. Of neighbours that disagree, only those count that go with the one nearest to the stroke:
// beyond the paper, so that fronts which meet keep their own coordinates. Seeds keep the coordinates of their
// own foot point. The front stops where P leaves the stroke's width. Upwind is a property of g alone, so the
// result does not depend on the processing order.
#include <burin/base/error.h>
#include <burin/chart/frame_step.h>
#include <burin/chart/seeds.h>
#include <burin/chart/stroke_chart.h>
#include <burin/chart/vertex_nodes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace burin {
namespace {

enum class State : std::uint8_t { reached, inside, outside };

struct Node {
  float g;  ///< graph distance from the stroke, object units
  State state;
  bool is_seed;
  float d;
  double t;
  Vec3f e1;
};

/// An entry of the front, lowest (g, vertex) first. Entries whose g has been improved since are skipped.
struct FrontEntry {
  float g;
  Index vertex;
  bool operator>(const FrontEntry& other) const {
    return std::pair(g, vertex) > std::pair(other.g, other.vertex);
  }
};

/// P(q) + T_q(x) and R(q, x) e1(q) of one upwind neighbour q.
struct Prediction {
  Index from;
  float length;  ///< |x - q|
  double t;
  float d;
  Vec3f e1;
};

/// Sums of Eq. 2 and 3. t is summed relative to one prediction's, for floats of full accuracy.
struct UpwindMean {
  float weight = 0, t = 0, d = 0;
  Vec3f e1 = Vec3f::Zero();
};

}  // namespace

struct StrokeCharter::Front {
  using Queue = std::priority_queue<FrontEntry, std::vector<FrontEntry>, std::greater<>>;

  explicit Front(const Surface& s) : surface(&s), index(s.vertex_count()) {}

  void start(const SurfaceCurve& curve, const ChartOptions& chart_options);
  void propagate();
  void settle(Index vertex, Node& node);
  bool average_upwind(Index vertex, Node& node);
  void collect_predictions(Index vertex);
  bool consistent(const Prediction& a, const Prediction& b) const;
  void add(UpwindMean& mean, const Prediction& prediction, double t_origin) const;
  bool within_width(const Node& node) const;
  void relax_neighbours(Index vertex, float g);
  void reach(Index vertex, float g);
  Chart collect() const;

  const Surface* surface;
  VertexNodes index;
  std::vector<Node> nodes;  ///< [node of index]
  Queue queue;
  std::vector<Prediction> predictions;  ///< of the vertex being settled
  ChartOptions options;
  double length = 0;
  float weight_epsilon = 0;  ///< keeps Eq. 2's weights finite; object units
};

void StrokeCharter::Front::start(const SurfaceCurve& curve, const ChartOptions& chart_options) {
  options = chart_options;
  length = curve.length();
  weight_epsilon = 4 * std::numeric_limits<float>::epsilon() * static_cast<float>(options.radius);
  nodes.clear();
  for (const Seed& seed : find_seeds(*surface, curve, index)) {
    nodes.push_back({seed.distance, State::reached, true, seed.d, seed.t, seed.e1});
    queue.push({seed.distance, seed.vertex});
  }
}

void StrokeCharter::Front::propagate() {
  while (!queue.empty()) {
    const FrontEntry next = queue.top();
    queue.pop();
    Node& node = nodes[index.find(next.vertex)];
    if (node.state != State::reached || next.g > node.g) continue;
    settle(next.vertex, node);
    if (node.state == State::inside) relax_neighbours(next.vertex, next.g);
  }
}

void StrokeCharter::Front::settle(Index vertex, Node& node) {
  const bool known = node.is_seed || average_upwind(vertex, node);
  node.state = known && within_width(node) ? State::inside : State::outside;
}

bool StrokeCharter::Front::average_upwind(Index vertex, Node& node) {
  collect_predictions(vertex);
  if (predictions.empty()) return false;
  const Prediction& nearest = *std::ranges::min_element(
      predictions, {}, [](const Prediction& p) { return std::pair(std::abs(p.d), p.from); });
  UpwindMean mean;
  for (const Prediction& prediction : predictions) {
    if (consistent(prediction, nearest)) add(mean, prediction, nearest.t);
  }
  node.t = nearest.t + static_cast<double>(mean.t / mean.weight);
  node.d = mean.d / mean.weight;

  const Vec3f& normal = surface->normals[vertex];
  const Vec3f tangent = mean.e1 - normal.dot(mean.e1) * normal;
  const float size = tangent.norm();
  node.e1 = size > 0 ? Vec3f(tangent / size) : normal.unitOrthogonal();
  return true;
}

void StrokeCharter::Front::collect_predictions(Index vertex) {
  predictions.clear();
  const Vec3f &x = surface->positions[vertex], &normal = surface->normals[vertex];
  for (const Index neighbour : surface->neighbours[vertex]) {
    const Index found = index.find(neighbour);
    if (found == no_index || nodes[found].state != State::inside) continue;
    const Node& q = nodes[found];
    const Vec3f& place = surface->positions[neighbour];
    const auto [step, e1] = step_along_edge(place, surface->normals[neighbour], q.e1, x, normal);
    predictions.push_back(
        {neighbour, (x - place).norm(), q.t + static_cast<double>(step.x()), q.d + step.y(), e1});
  }
}

/// Where fronts of different parts of the stroke meet, the mean of their coordinates would mean nothing.
bool StrokeCharter::Front::consistent(const Prediction& a, const Prediction& b) const {
  const double reach = 2 * static_cast<double>(a.length + b.length);
  return std::hypot(a.t - b.t, static_cast<double>(a.d - b.d)) <= reach;
}

void StrokeCharter::Front::add(UpwindMean& mean, const Prediction& prediction, double t_origin) const {
  const float w = 1 / (prediction.length + weight_epsilon);
  mean.weight += w;
  mean.t += w * static_cast<float>(prediction.t - t_origin);
  mean.d += w * prediction.d;
  mean.e1 += w * prediction.e1;
}

bool StrokeCharter::Front::within_width(const Node& node) const {
  const double beyond = std::max({-node.t, node.t - length, 0.});
  // The graph distance is never much longer than the geodesic: beyond, the coordinates have gone astray.
  if (static_cast<double>(node.g) > 2 * options.radius) return false;
  return std::hypot(beyond, static_cast<double>(node.d)) <= options.radius;
}

void StrokeCharter::Front::relax_neighbours(Index vertex, float g) {
  const Vec3f& q = surface->positions[vertex];
  for (const Index neighbour : surface->neighbours[vertex]) {
    const float along_edge = g + (surface->positions[neighbour] - q).norm();
    // Edges too short to tell in floats still lead downwind, or Upwind would depend on the order.
    reach(neighbour, std::max(along_edge, std::nextafter(g, std::numeric_limits<float>::infinity())));
  }
}

void StrokeCharter::Front::reach(Index vertex, float g) {
  Index found = index.find(vertex);
  if (found == no_index) {
    found = index.insert(vertex);
    nodes.push_back({std::numeric_limits<float>::infinity(), State::reached, false, 0, 0, Vec3f::Zero()});
  }
  Node& node = nodes[found];
  if (node.state != State::reached || g >= node.g) return;
  node.g = g;
  node.is_seed = false;
  queue.push({g, vertex});
}

Chart StrokeCharter::Front::collect() const {
  std::vector<Index> inside;
  for (Index node = 0; node < nodes.size(); ++node) {
    const bool at_end = nodes[node].t < 0 || nodes[node].t > length;
    if (nodes[node].state == State::inside && !(at_end && options.cap == Cap::butt)) inside.push_back(node);
  }
  std::ranges::sort(inside, {}, [this](Index node) { return index.vertex(node); });

  Chart chart;
  chart.vertex.reserve(inside.size());
  chart.t.reserve(inside.size());
  chart.d.reserve(inside.size());
  chart.e1.reserve(inside.size());
  for (const Index node : inside) {
    chart.vertex.push_back(index.vertex(node));
    chart.t.push_back(nodes[node].t);
    chart.d.push_back(nodes[node].d);
    chart.e1.push_back(nodes[node].e1);
  }
  return chart;
}

StrokeCharter::StrokeCharter(const Surface& surface) : front_(std::make_unique<Front>(surface)) {}
StrokeCharter::~StrokeCharter() = default;
StrokeCharter::StrokeCharter(StrokeCharter&&) noexcept = default;
StrokeCharter& StrokeCharter::operator=(StrokeCharter&&) noexcept = default;

Chart StrokeCharter::chart(const SurfaceCurve& curve, const ChartOptions& options) {
  if (!std::isfinite(options.radius) || options.radius <= 0) {
    throw ContractError("a stroke's radius must be a finite number above 0");
  }
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  front_->start(curve, options);
  front_->propagate();
  return front_->collect();
}

}  // namespace burin
