// Joins the nodes of one vertex, in O(n^2 + n b) for n nodes and b bends at which the stroke is not cut.
#include <burin/chart/joins/leg_choice.h>
#include <burin/chart/joins/vertex_join.h>
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace burin {
namespace {

/// By how much, in radii, the parts of an overlap reach past their joints, where neither may have a foot of
/// its own.
constexpr double overlap_margin = 1. / 32;

/// A node past an end of its leg with the coordinates of a round join: t of the end, and the distance from it
/// on the side on which the node lies.
LegNode turned_around_end(LegNode node, const Vec3f& normal) {
  ChartFrame& frame = node.frame;
  const float side = frame.d < 0 ? -1 : 1;
  const Vec3f away = static_cast<float>(node.past) * frame.e1 + frame.d * normal.cross(frame.e1);
  if (away.squaredNorm() > 0) frame.e1 = side * away.cross(normal).normalized();
  frame.t -= node.past;
  frame.d = side * static_cast<float>(node.distance);
  return node;
}

}  // namespace

VertexJoin::VertexJoin(const StrokeLegs& legs, const SurfaceCurve& curve, const ChartOptions& options)
    : legs_(legs), curve_(curve), options_(options), uniform_(has_uniform_width(curve)) {}

void VertexJoin::join(std::vector<LegNode>& nodes, const Vec3f& normal) const {
  for (LegNode& node : nodes) measure(node);
  std::ranges::sort(nodes, {}, [](const LegNode& node) {
    return std::tuple(node.is_of_bend(), node.part, node.frame.t, node.slot);
  });
  const auto first_of_bends = std::ranges::find_if(nodes, &LegNode::is_of_bend);
  const Nodes of_legs(nodes.begin(), first_of_bends), of_bends(first_of_bends, nodes.end());
  const std::optional<LegNode> nearest = nearest_of(of_legs, normal);
  if (options_.join != Join::overlap && !legs_.cuts().empty())
    choose_at_corners(of_legs, legs_.ends(), options_.radius);
  if (options_.join == Join::smooth) smooth(of_legs, of_bends, normal);
  for (LegNode& node : nodes) node.dropped = node.dropped || !is_inside(node);
  if (options_.join != Join::overlap) fill_from_bends(of_legs, of_bends, normal);
  std::erase_if(nodes, [](const LegNode& node) { return node.dropped; });
  if (nodes.empty() && nearest) nodes.push_back(*nearest);
  if (legs_.closed())
    for (LegNode& node : nodes) node.frame.t = wrapped_t(node.frame.t, legs_.length());
  // Sorting allocates memory, which most vertices do not need.
  if (nodes.size() > 1) std::ranges::stable_sort(nodes, {}, [](const LegNode& node) { return node.frame.t; });
}

/// Computes how far a node is from its leg or bend, and how far past an end of it.
void VertexJoin::measure(LegNode& node) const {
  const double t = node.frame.t;
  const Leg part = node.is_of_bend() ? legs_.bend(node.cut()) : legs_.legs()[node.leg()];
  const bool endless = legs_.closed() && legs_.cuts().empty();
  node.past = endless ? 0 : t - std::clamp(t, part.begin, part.end);
  node.distance = math::hypot(node.past, static_cast<double>(node.frame.d));
  node.half_width = options_.radius * (uniform_ ? 1 : static_cast<double>(point_at(curve_, t).width));
  node.continued = node.past != 0 && (node.past < 0 ? part.reach.begin : part.reach.end) > 0;
}

/// Whether a node lies past an end within the stroke.
bool VertexJoin::is_past_joint(const LegNode& node) const {
  if (node.past == 0) return false;
  if (node.is_of_bend()) return true;
  const auto& [before, after] = legs_.ends()[node.leg()];
  return node.past < 0 ? before.has_value() : after.has_value();
}

/// Whether a straight cap of the stroke cuts the node off.
bool VertexJoin::is_cut_off(const LegNode& node) const {
  return options_.cap == Cap::butt && beyond_ends(node.frame.t, legs_.length(), legs_.closed()) > 0;
}

bool VertexJoin::is_inside(const LegNode& node) const {
  if (is_cut_off(node) || static_cast<double>(std::abs(node.frame.d)) > node.half_width) return false;
  if (options_.join == Join::overlap && std::abs(node.past) > overlap_margin * options_.radius &&
      is_past_joint(node))
    return false;
  // Beyond ends that are continued, nodes may be farther from the leg than the half width.
  return node.continued || node.distance <= node.half_width;
}

/// The node that is nearest to its leg, with the coordinates of a round join where it lies past a joint, if
/// it is within the stroke.
std::optional<LegNode> VertexJoin::nearest_of(Nodes of_legs, const Vec3f& normal) const {
  const auto nearest = std::ranges::min_element(of_legs, {}, &LegNode::distance);
  if (nearest == of_legs.end() || nearest->distance > nearest->half_width || is_cut_off(*nearest)) return {};
  return is_past_joint(*nearest) ? turned_around_end(*nearest, normal) : *nearest;
}

void VertexJoin::smooth(Nodes of_legs, Nodes of_bends, const Vec3f& normal) const {
  for (LegNode& node : of_legs) {
    if (node.dropped) continue;
    const auto& [before, after] = legs_.ends()[node.leg()];
    if (after) smooth_corner(node, *after, of_bends, normal);
    if (before) smooth_corner(node, *before, of_bends, normal);
    for (const SpreadBend& bend : legs_.uncut_around(node.frame.t)) smooth_bend(node, bend);
    // A leg that goes on beyond a joint near an end of the stroke would else tell of places beyond that end.
    if (after && !legs_.closed()) node.frame.t = std::min(node.frame.t, legs_.length());
    if (before && !legs_.closed()) node.frame.t = std::max(node.frame.t, 0.0);
  }
}

/// Within the bend of a smooth corner the distance and e1 are the bend's own: the circle around the point
/// where the continued legs meet lies off a bend that is rounded. Its far side, which no node of the bend
/// reaches, keeps the distance from the end of the leg and is outside of the stroke.
void VertexJoin::smooth_corner(LegNode& node, const LegEnd& end, Nodes of_bends, const Vec3f& normal) const {
  const Leg& leg = legs_.legs()[node.leg()];
  const double beyond = end.first_leg ? node.frame.t - leg.end : leg.begin - node.frame.t;
  const bool inside = static_cast<double>(node.frame.d) * end.corner.turn > 0;
  if (beyond > 0 && inside && !end.continued) {
    node = turned_around_end(node, normal);
    return;
  }
  node.frame = smoothed(end.corner, end.first_leg, node.frame, normal);
  if (beyond <= 0) return;
  double distance = node.distance;
  for (const LegNode& of_bend : of_bends) {
    if (of_bend.part != part_of_cut(end.cut) || of_bend.distance >= distance) continue;
    distance = of_bend.distance;
    node.frame.e1 = of_bend.frame.e1;
  }
  node.frame.d = std::copysign(static_cast<float>(distance), node.frame.d);
}

void VertexJoin::smooth_bend(LegNode& node, const SpreadBend& spread) const {
  const double length = legs_.length();
  const double loops = legs_.closed() ? std::round((node.frame.t - spread.bend.middle) / length) : 0;
  node.frame.t -= loops * length;
  node.frame = smoothed(legs_.bends(), spread.bend, spread.span, node.frame);
  node.frame.t += loops * length;
}

/// Drops the nodes of the bends at corners where the vertex has a node of a leg.
void VertexJoin::fill_from_bends(Nodes of_legs, Nodes of_bends, const Vec3f& normal) const {
  const bool held = std::ranges::any_of(of_legs, [](const LegNode& node) { return !node.dropped; });
  for (LegNode& node : of_bends) {
    node.dropped = node.dropped || held;
    if (node.past != 0) node = turned_around_end(node, normal);
    if (options_.join == Join::smooth && !node.dropped) smooth_bend(node, legs_.cuts()[node.cut()]);
  }
}

}  // namespace burin
