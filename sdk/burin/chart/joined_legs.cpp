#include <burin/chart/curve_parts.h>
#include <burin/chart/joined_legs.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin {
namespace {

/// A bend shorter than this share of the radius is a corner.
constexpr double corner_length = 0.5;

}  // namespace

void JoinedLegs::begin(const ChartOptions& options) {
  options_ = options;
  charted_.clear();
  front_leg_.reset();
}

void JoinedLegs::place(const SurfaceCurve& curve, double unchanged_t, Front& front,
                       std::vector<PlacedNode>& nodes) {
  cuts_.clear();
  corners_.clear();
  if (options_.join != Join::round) find_corners(curve);
  const std::vector<Leg> legs = legs_of(curve);
  charted_.resize(legs.size());
  settled_ = pushes_ = 0;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    if (curve.closed || !as_charted(leg, legs[leg], unchanged_t)) chart(curve, leg, legs[leg], front);
    nodes.insert(nodes.end(), charted_[leg].nodes.begin(), charted_[leg].nodes.end());
  }
  if (options_.join != Join::overlap) put_together(nodes, curve.closed);
  if (options_.join == Join::smooth) smooth_long_bends(curve, nodes);
  // Joins move coordinates: some now lie beyond the stroke.
  std::erase_if(nodes, [&](const PlacedNode& node) {
    return static_cast<double>(std::abs(node.frame.d)) > node.half_width ||
           (options_.cap == Cap::butt && beyond_end(node.frame.t, curve));
  });
}

void JoinedLegs::find_corners(const SurfaceCurve& curve) {
  GeodesicCurvature curvature;
  curvature.update(curve, Front::curvature_window * options_.radius);
  bends_.update(curve, curvature, options_.radius);
  for (const Bend& bend : bends_.all()) {
    const bool is_short = bend.end - bend.begin < corner_length * options_.radius;
    const bool miterable = miter_reach(bend.turn, options_.radius) > 0;
    if (options_.join != Join::overlap && !is_short) continue;
    if (options_.join == Join::miter && !miterable) continue;
    if (!curve.closed && (bend.begin <= 0 || bend.end >= curve.length())) continue;
    const Vec3d from = point_at(curve, bend.begin).at.position.cast<double>();
    const double chord = (point_at(curve, bend.end).at.position.cast<double>() - from).norm();
    const double way = std::min(chord / 2 / math::cos(bounded_half(bend.turn)), options_.radius);
    cuts_.push_back(bend);
    corners_.push_back({bend.begin + way, bend.end - way, bend.middle, bend.turn, span(curve, bend)});
  }
}

/// Enough for |grad t| within 1/2 and 2 at right angles, but not into another bend's half nor beyond an end.
double JoinedLegs::span(const SurfaceCurve& curve, const Bend& bend) const {
  const double length = curve.length();
  double span = 4 * options_.radius * math::tan(bounded_half(bend.turn));
  span = curve.closed ? std::min(span, length / 2) : std::min({span, bend.middle, length - bend.middle});
  for (const Bend& other : bends_.all()) {
    double gap = std::abs(other.middle - bend.middle);
    if (curve.closed) gap = std::min(gap, length - gap);
    if (other.middle != bend.middle) span = std::min(span, gap / 2);
  }
  return span;
}

std::vector<JoinedLegs::Leg> JoinedLegs::legs_of(const SurfaceCurve& curve) const {
  std::vector<Leg> legs;
  const auto add = [&](double begin, double end) {
    const std::size_t leg = legs.size();
    const Corner *before = corner_before(leg, curve.closed), *after = corner_after(leg, curve.closed);
    legs.push_back(
        {begin, std::max(begin, end), {reach(before), reach(after)}, before != nullptr, after != nullptr});
  };
  if (cuts_.empty()) {
    add(0, curve.length());
    return legs;
  }
  if (!curve.closed) add(0, cuts_.front().begin);
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) add(cuts_[i].end, cuts_[i + 1].begin);
  add(cuts_.back().end, curve.closed ? cuts_.front().begin + curve.length() : curve.length());
  return legs;
}

double JoinedLegs::reach(const Corner* corner) const {
  if (!corner || options_.join != Join::miter) return 0;
  return 1.1 * miter_reach(corner->turn, options_.radius) + corner_length * options_.radius;
}

const Corner* JoinedLegs::corner_after(std::size_t leg, bool closed) const {
  if (closed && !corners_.empty()) return &corners_[(leg + 1) % corners_.size()];
  return leg < corners_.size() ? &corners_[leg] : nullptr;
}

const Corner* JoinedLegs::corner_before(std::size_t leg, bool closed) const {
  if (closed && !corners_.empty()) return &corners_[leg];
  return leg > 0 ? &corners_[leg - 1] : nullptr;
}

bool JoinedLegs::as_charted(std::size_t leg, const Leg& now, double unchanged_t) const {
  return charted_[leg].leg == now && now.end < unchanged_t;
}

/// The last leg of a stroke that grows goes on with the front where that stands.
void JoinedLegs::chart(const SurfaceCurve& curve, std::size_t leg, const Leg& now, Front& front) {
  const bool whole = cuts_.empty();
  const SurfaceCurve part = whole ? curve : part_of(curve, now.begin, now.end);
  const bool goes_on =
      front_leg_ && !curve.closed && front_leg_->begin == now.begin && front_leg_->reach == now.reach;
  if (!goes_on) front.restart(options_.radius, options_.order, now.reach);
  front.update(part);
  settled_ += front.settled();
  pushes_ += front.pushes();
  front_leg_ = now;
  charted_[leg] = {now, {}};
  const std::vector<std::vector<const FrontNode*>> inside = front.inside();
  for (const FrontNode* node : inside[0]) {
    ChartFrame frame = node->frame;
    const bool inner_end =
        options_.join != Join::overlap && (frame.t < 0 ? now.corner_before : now.corner_after);
    if (options_.cap == Cap::butt && beyond_end(frame.t, part) && !inner_end) continue;
    const double half_width = front.half_width(frame.t);
    frame.t += whole ? 0 : now.begin;
    charted_[leg].nodes.push_back({node->vertex(), static_cast<Index>(leg), frame, half_width});
  }
}

/// At each corner a vertex keeps the node of the leg on whose side of the bisector it lies: that goes less
/// far beyond the corner.
void JoinedLegs::put_together(std::vector<PlacedNode>& nodes, bool closed) const {
  if (corners_.empty()) return;
  std::ranges::sort(nodes, {}, [](const PlacedNode& n) { return std::tuple(n.vertex, n.leg, n.frame.t); });
  const double near = 4 * options_.radius;
  const auto keeps = [&](const PlacedNode& node, std::size_t first, std::size_t last, const Corner* corner,
                         bool first_leg) {
    if (!corner) return true;
    const double beyond = first_leg ? node.frame.t - corner->first : corner->second - node.frame.t;
    if (beyond < -near) return true;
    for (std::size_t i = first; i < last; ++i) {
      const bool neighbour = first_leg ? nodes[i].leg == node.leg + 1 : nodes[i].leg + 1 == node.leg;
      const double other = first_leg ? corner->second - nodes[i].frame.t : nodes[i].frame.t - corner->first;
      if (neighbour && other > -near) return first_leg ? beyond <= other : beyond < other;
    }
    return beyond <= 0 || on_own_side(*corner, first_leg, node.frame);
  };
  std::vector<PlacedNode> kept;
  for (std::size_t first = 0; first < nodes.size();) {
    std::size_t last = first;
    while (last < nodes.size() && nodes[last].vertex == nodes[first].vertex) ++last;
    for (std::size_t i = first; i < last; ++i) {
      PlacedNode node = nodes[i];
      const Corner *before = corner_before(node.leg, closed), *after = corner_after(node.leg, closed);
      if (!keeps(node, first, last, after, true) || !keeps(node, first, last, before, false)) continue;
      if (options_.join == Join::smooth) {
        const Vec3f normal = ground_[node.vertex].normal;
        if (after) node.frame = smoothed(*after, true, node.frame, normal);
        if (before) node.frame = smoothed(*before, false, node.frame, normal);
      }
      kept.push_back(node);
    }
    first = last;
  }
  nodes = std::move(kept);
}

void JoinedLegs::smooth_long_bends(const SurfaceCurve& curve, std::vector<PlacedNode>& nodes) const {
  for (const Bend& bend : bends_.all()) {
    if (bend.end - bend.begin < corner_length * options_.radius) continue;
    const double reach = span(curve, bend), length = curve.length();
    for (PlacedNode& node : nodes) {
      const double t = node.frame.t;
      const double loops = curve.closed ? std::round((t - bend.middle) / length) : 0;
      node.frame.t = smoothed_t(bends_, bend, reach, t - loops * length, static_cast<double>(node.frame.d)) +
                     loops * length;
    }
  }
}

}  // namespace burin
