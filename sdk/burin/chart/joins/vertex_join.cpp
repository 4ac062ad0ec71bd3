// Joins the nodes of one vertex, in O(n^2 + n b) for n nodes and b bends that are not corners.
#include <burin/chart/joins/leg_choice.h>
#include <burin/chart/joins/vertex_join.h>
#include <burin/chart/path/closed_length.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

VertexJoin::VertexJoin(const StrokeLegs& legs, const SurfaceCurve& curve, const ChartOptions& options)
    : legs_(legs), curve_(curve), options_(options), uniform_(has_uniform_width(curve)) {}

void VertexJoin::join(std::vector<LegNode>& nodes, const Vec3f& normal) const {
  for (LegNode& node : nodes) measure(node);
  const auto first_of_bends =
      std::ranges::find_if(nodes, [&](const LegNode& node) { return is_of_bend(node); });
  const Nodes of_legs(nodes.begin(), first_of_bends), of_bends(first_of_bends, nodes.end());
  const auto nearest = std::ranges::min_element(of_legs, {}, &LegNode::distance);
  const std::optional<LegNode> last = nearest == of_legs.end() ? std::nullopt : std::optional(*nearest);
  if (options_.join != Join::overlap && !legs_.cuts().empty())
    choose_at_corners(of_legs, legs_.ends(), corner_nearness * options_.radius);
  if (options_.join == Join::smooth) smooth(of_legs, of_bends, normal);
  for (LegNode& node : nodes) node.dropped = node.dropped || !is_inside(node);
  fill_from_bends(of_legs, of_bends);
  std::erase_if(nodes, [](const LegNode& node) { return node.dropped; });
  if (nodes.empty() && last && last->distance <= last->half_width && is_inside(*last)) nodes.push_back(*last);
  if (legs_.closed())
    for (LegNode& node : nodes) node.frame.t = wrapped_t(node.frame.t, legs_.length());
}

/// Computes how far a node is from its leg or bend, and whether it lies where that goes on.
void VertexJoin::measure(LegNode& node) const {
  const double t = node.frame.t, d = static_cast<double>(node.frame.d);
  const Leg part = is_of_bend(node) ? legs_.bend(node.leg - leg_count()) : legs_.legs()[node.leg];
  const bool endless = legs_.closed() && legs_.cuts().empty();
  const double past = endless ? 0 : std::max({part.begin - t, t - part.end, 0.});
  node.distance = past > 0 ? std::sqrt(past * past + d * d) : std::abs(d);
  node.half_width = options_.radius * (uniform_ ? 1 : static_cast<double>(point_at(curve_, t).width));
  node.continued = past > 0 && (t < part.begin ? part.reach.begin : part.reach.end) > 0;
}

/// Whether a straight end of the stroke or of the node's leg cuts the node off.
bool VertexJoin::is_cut_off(const LegNode& node) const {
  if (options_.cap != Cap::butt) return false;
  if (beyond_ends(node.frame.t, legs_.length(), legs_.closed()) > 0) return true;
  if (options_.join != Join::overlap || is_of_bend(node) || legs_.cuts().empty()) return false;
  const Leg& leg = legs_.legs()[node.leg];
  return node.frame.t < leg.begin || node.frame.t > leg.end;
}

bool VertexJoin::is_inside(const LegNode& node) const {
  if (is_cut_off(node) || static_cast<double>(std::abs(node.frame.d)) > node.half_width) return false;
  // Beyond ends that are continued, nodes may be farther from the leg than the half width.
  return node.continued || node.distance <= node.half_width;
}

void VertexJoin::smooth(Nodes of_legs, Nodes of_bends, const Vec3f& normal) const {
  for (LegNode& node : of_legs) {
    if (node.dropped) continue;
    const auto& [before, after] = legs_.ends()[node.leg];
    if (after) smooth_corner(node, *after, of_bends, normal);
    if (before) smooth_corner(node, *before, of_bends, normal);
    for (const SpreadBend& bend : legs_.uncut()) smooth_bend(node, bend);
  }
}

/// Within the bend of a smooth corner the distance and e1 are the bend's own: the circle around the point
/// where the continued legs meet lies off a bend that is rounded. Its far side, which no node of the bend
/// reaches, keeps the distance from the end of the leg and is outside of the stroke.
void VertexJoin::smooth_corner(LegNode& node, const LegEnd& end, Nodes of_bends, const Vec3f& normal) const {
  const Leg& leg = legs_.legs()[node.leg];
  const double beyond = end.first_leg ? node.frame.t - leg.end : leg.begin - node.frame.t;
  node.frame = smoothed(end.corner, end.first_leg, node.frame, normal);
  if (beyond <= 0) return;
  double distance = node.distance;
  for (const LegNode& of_bend : of_bends) {
    if (of_bend.leg != leg_count() + end.cut || of_bend.distance >= distance) continue;
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

/// Drops the nodes of corners where a vertex has others.
void VertexJoin::fill_from_bends(Nodes of_legs, Nodes of_bends) const {
  const auto is_held = [](const LegNode& node) { return !node.dropped; };
  const auto cut_of = [&](const LegNode& node) { return legs_.cuts()[node.leg - leg_count()]; };
  const bool held =
      std::ranges::any_of(of_legs, is_held) || std::ranges::any_of(of_bends, [&](const LegNode& node) {
        return !node.dropped && !legs_.is_corner(cut_of(node));
      });
  for (LegNode& node : of_bends) {
    if (!legs_.is_corner(cut_of(node))) continue;
    node.dropped = node.dropped || held;
    if (options_.join == Join::smooth && !node.dropped) smooth_bend(node, cut_of(node));
  }
}

}  // namespace burin
