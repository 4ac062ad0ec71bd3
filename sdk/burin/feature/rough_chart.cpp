// A chart after [Schmidt 2013, section 4]: nodes are settled in the order of their distance from the stroke;
// each has the mean of the coordinates that the nodes settled before it tell, weighted by the inverse squares
// of their distances. Lines of constant d are circles, whose curvature follows from that of the stroke and of
// the surface, to second order in the length of edges.
#include <burin/chart/frames/foot.h>
#include <burin/chart/frames/frame_step.h>
#include <burin/chart/path/closed_length.h>
#include <burin/feature/rough_chart.h>
#include <burin/surface/geometry/parallel_transport.h>
#include <burin/surface/geometry/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// g rises by this share of an edge at least, so that false coordinates do not lead the front astray.
constexpr float least_progress = 0.3F;

/// The stroke's curvature is estimated over this many radii to either side.
constexpr double curvature_window = 0.25;

}  // namespace

RoughCharter::RoughCharter(const Surface& surface)
    : surface_(surface), first_(surface.vertex_count(), no_index), inside_(surface.vertex_count()) {}

Chart RoughCharter::chart(const SurfaceCurve& curve, double radius) {
  restart(curve, radius);
  for (std::size_t segment = 0; segment < curve.segment_count(); ++segment) {
    seed_around(segment, segment);
    seed_around(curve.next(segment), segment);
  }
  for (Node& node : nodes_) node.settled = true;  // Seeds have their coordinates.
  spread();
  return collect();
}

void RoughCharter::restart(const SurfaceCurve& curve, double radius) {
  constexpr double radii_apart = 4;
  curve_ = &curve;
  radius_ = radius;
  length_ = curve.length();
  apart_ = radii_apart * radius;
  curvature_.update(curve, curvature_window * radius);
  path_.clear();
  path_.update(curve, curvature_, radius, 1e-6 * surface_.scale, 0);
  nodes_.clear();
  queue_.restart(static_cast<float>(2 * radius));
}

float RoughCharter::distance(double t, float d) const {
  const double beyond = beyond_ends(t, length_, curve_->closed);
  return beyond == 0 ? std::abs(d) : static_cast<float>(std::sqrt(beyond * beyond + double{d} * double{d}));
}

/// The node of the visit to a vertex that an arc length belongs to.
Index RoughCharter::node_at(Index vertex, double t) {
  for (Index at = first_[vertex]; at != no_index; at = nodes_[at].next) {
    const double near = nodes_[at].near;
    if (std::abs((curve_->closed ? t_nearest_to(near, t, length_) : t) - near) < apart_) return at;
  }
  const auto added = static_cast<Index>(nodes_.size());
  nodes_.push_back({.vertex = vertex, .next = first_[vertex], .near = t});
  first_[vertex] = added;
  return added;
}

void RoughCharter::reach(Index node, float g) {
  Node& reached = nodes_[node];
  if (g >= reached.g) return;
  reached.g = g;
  queue_.push(front_key(g, reached.vertex), node);
}

/// Places the corners of the triangle of a point of the curve beside a segment, where that is the nearest.
void RoughCharter::seed_around(std::size_t point, std::size_t segment) {
  for (const Index vertex : curve_->points[point].at.corners) {
    const Foot foot = foot_on(*curve_, segment, surface_.positions[vertex]);
    const Index node = node_at(vertex, arc_length_at(*curve_, foot));
    if (!(foot.distance < nodes_[node].g)) continue;
    seed(nodes_[node], foot);
    reach(node, foot.distance);
  }
}

void RoughCharter::seed(Node& node, const Foot& foot) const {
  const std::size_t next = curve_->next(foot.segment);
  const CurvePoint& at = curve_->points[foot.s < 0.5F ? foot.segment : next];
  const double t = arc_length_at(*curve_, foot);
  const auto [step, e1] = step_along_edge(foot.position, at.normal, at.tangent,
                                          surface_.positions[node.vertex], surface_.normals[node.vertex]);
  const bool beyond = !curve_->closed && ((t == 0 && step.x() < 0) || (t == length_ && step.x() > 0));
  node.weight = 1;
  node.near = t;
  node.t = beyond ? static_cast<double>(step.x()) : 0;
  node.d = beyond ? step.y() : std::copysign(foot.distance, step.y());
  node.e1 = e1;
  const float k = beyond ? 0 : (1 - foot.s) * curvature_[foot.segment] + foot.s * curvature_[next];
  const float gauss = surface_.gauss_curvature[node.vertex], d = node.d;
  // On the inside of a bend whose centre is nearer than the seed coordinates fold, and count as straight.
  const bool folds = k * d >= 0.5F;
  node.curvature = folds ? 0 : k / (1 - k * d) + gauss * d;
  node.stretch = folds ? 1 : 1 - k * d - gauss * d * d / 2;
}

void RoughCharter::spread() {
  while (!queue_.empty()) {
    const BucketQueue::Entry next = queue_.top();
    queue_.pop();
    Node& node = nodes_[next.node];
    if (node.inside || front_key(node.g, node.vertex) != next.key) continue;
    settle(node);
    if (!node.inside) continue;
    inside_.insert(node.vertex);
    lead_on(Node(node));
  }
}

/// Divides the sums by their weights.
void RoughCharter::settle(Node& node) const {
  node.t = node.near + node.t / static_cast<double>(node.weight);
  if (curve_->closed) node.t = wrapped_t(node.t, length_);
  node.d /= node.weight;
  node.e1 = unit_tangent(node.e1, surface_.normals[node.vertex]);
  const bool beyond = beyond_ends(node.t, length_, curve_->closed) > 0;
  node.curvature = beyond ? 0 : node.curvature / node.weight;
  node.stretch = beyond ? 1 : std::max(node.stretch / node.weight, least_stretch);
  node.settled = true;
  // Where the stroke turns away from straight on, coordinates that went on so tell of too short distances.
  constexpr double most_excess = 0.05;
  node.inside = distance(node.t, node.d) <= static_cast<float>(radius_) &&
                path_.excess(node.t, static_cast<double>(node.d), surface_.positions[node.vertex]) <=
                    most_excess * radius_;
}

/// Tells the neighbours that are not settled where they are, as seen from a node.
void RoughCharter::lead_on(const Node& from) {
  const Vec3f& normal = surface_.normals[from.vertex];
  const Vec3f e2 = normal.cross(from.e1);
  const float inverse_stretch = 1 / from.stretch;
  for (const Index neighbour : surface_.neighbours[from.vertex]) {
    const Index index = node_at(neighbour, from.t);
    Node& to = nodes_[index];
    if (to.settled) continue;
    const Vec3f chord = surface_.positions[neighbour] - surface_.positions[from.vertex];
    const float ahead = chord.dot(from.e1), beside = chord.dot(e2);
    const float squared = chord.squaredNorm(), flat = ahead * ahead + beside * beside;
    if (!(flat > 0)) continue;
    // The edge with its length in the tangent plane.
    const float scale = std::sqrt(squared / flat), u = scale * ahead, v = scale * beside;
    // Nearer to the centre of the circles than two edges the line is taken for straight.
    const float k = 4 * from.curvature * from.curvature * squared < 1 ? from.curvature : 0;
    const float along = u * (1 + k * v), across = v - k * u * u / 2 * (1 + k * v);
    const double t = from.t + static_cast<double>(along * inverse_stretch);
    const float d = from.d + across;
    const double nearest_t = curve_->closed ? t_nearest_to(to.near, t, length_) : t;
    const float g = std::max(distance(t, d), from.g + least_progress * std::sqrt(squared));
    if (disagrees(to, nearest_t, d, squared, from.stretch)) {
      // Fronts from two parts of the stroke meet; the nearer part takes the node.
      if (g >= to.g) continue;
      to = {.vertex = to.vertex, .next = to.next, .g = to.g, .near = nearest_t};
    }
    const float weight = 1 / squared, bulge = surface_.gauss_curvature[neighbour] * across;
    to.weight += weight;
    to.t += static_cast<double>(weight) * (nearest_t - to.near);
    to.d += weight * d;
    to.e1 += weight * transport(from.e1 + k * u * e2, normal, surface_.normals[neighbour]);
    to.curvature += weight * (k * (1 + k * v) + bulge);
    to.stretch += weight * from.stretch * (1 - k * v + k * k * u * u / 2 - bulge * across / 2);
    reach(index, g);
  }
}

/// Whether coordinates that a node is told, over an edge of this squared length, are far from the mean of
/// those that it was told before.
bool RoughCharter::disagrees(const Node& node, double t, float d, float squared_length, float stretch) {
  constexpr float most_edges = 4;
  if (!(node.weight > 0)) return false;
  const auto along = static_cast<float>(t - node.near - node.t / static_cast<double>(node.weight)) * stretch;
  const float across = d - node.d / node.weight;
  return along * along + across * across > most_edges * most_edges * squared_length;
}

/// Sorts the nodes inside by vertex and t, and forgets all nodes.
Chart RoughCharter::collect() {
  inside_.drain(vertices_);
  Chart chart;
  chart.length = length_;
  chart.closed = curve_->closed;
  chart.resize(nodes_.size());
  std::size_t count = 0;
  std::vector<const Node*> visits;
  for (const Index vertex : vertices_) {
    visits.clear();
    for (Index at = first_[vertex]; at != no_index; at = nodes_[at].next)
      if (nodes_[at].inside) visits.push_back(&nodes_[at]);
    std::ranges::sort(visits, {}, &Node::t);
    for (std::uint32_t sheet = 0; sheet < visits.size(); ++sheet) {
      const Node& node = *visits[sheet];
      chart.set(count++, vertex, sheet, {node.t, node.d, node.e1, node.curvature, node.stretch},
                surface_.normals[vertex]);
    }
  }
  chart.resize(count);
  for (const Node& node : nodes_) first_[node.vertex] = no_index;
  return chart;
}

}  // namespace burin
