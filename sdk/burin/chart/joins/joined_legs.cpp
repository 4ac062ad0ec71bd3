// Cuts a stroke at its bends into legs, charts each leg and each bend by a front, and selects for each vertex
// the nodes that the kind of join keeps. For n nodes in total it costs O(n log n); legs that did not change
// since the last call are not charted again.
#include <burin/chart/joins/joined_legs.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <tuple>

namespace burin {
namespace {

/// A bend shorter than this share of the radius is a corner.
constexpr double corner_length = 0.5;

/// The vertices of the nodes, ascending.
std::vector<Index> vertices_of(const std::vector<LegNode>& nodes) {
  std::vector<Index> vertices;
  vertices.reserve(nodes.size());
  for (const LegNode& node : nodes) vertices.push_back(node.vertex);
  std::ranges::sort(vertices);
  return vertices;
}

/// Whether a node lies outside of the disc, of the usual size, around its foot. The discs of extended legs
/// are wider and let false frames pass where the surface folds.
bool outside_disc(const StrokePath& path, const FrontNode& node, double half_width) {
  const double t = node.frame.t, d = static_cast<double>(node.frame.d);
  return path.chart_distance(t, d) + path.excess(t, d, node.position) > disc_over_width * half_width;
}

}  // namespace

void JoinedLegs::begin(const ChartOptions& options) {
  options_ = options;
  charted_.clear();
  charted_bends_.clear();
  front_leg_.reset();
}

void JoinedLegs::place(const SurfaceCurve& curve, double unchanged_t, Front& front,
                       std::vector<LegNode>& nodes) {
  cuts_.clear();
  corners_.clear();
  if (options_.join != Join::round) find_corners(curve);
  const std::vector<Leg> legs = legs_of(curve);
  charted_.resize(legs.size());
  settled_ = pushes_ = 0;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    if (curve.closed || !charted_[leg].is(legs[leg], unchanged_t)) chart(curve, leg, legs[leg], front);
    nodes.insert(nodes.end(), charted_[leg].nodes.begin(), charted_[leg].nodes.end());
  }
  chart_bends(curve, unchanged_t);
  const bool chosen = !corners_.empty() && options_.join != Join::overlap;
  if (chosen) select_nodes(nodes, curve.closed);
  if (options_.join == Join::smooth) smooth_long_bends(curve, nodes);
  // Joins move coordinates, so some nodes now lie outside the stroke.
  std::erase_if(nodes, [&](const LegNode& node) {
    return static_cast<double>(std::abs(node.frame.d)) > node.half_width ||
           (options_.cap == Cap::butt && beyond_end(node.frame.t, curve));
  });
  add_bends(curve, nodes);
  if (chosen) keep_last(curve, nodes);
}

bool JoinedLegs::is_corner(const Bend& bend) const {
  return bend.end - bend.begin < corner_length * options_.radius;
}

void JoinedLegs::find_corners(const SurfaceCurve& curve) {
  GeodesicCurvature curvature;
  curvature.update(curve, Front::curvature_window * options_.radius);
  bends_.update(curve, curvature, options_.radius);
  for (const Bend& bend : bends_.all()) {
    const bool miterable = miter_reach(bend.turn, options_.radius) > 0;
    if (options_.join != Join::overlap && !is_corner(bend)) continue;
    if (options_.join == Join::miter && !miterable) continue;
    if (!curve.closed && (bend.begin <= 0 || bend.end >= curve.length())) continue;
    const Vec3d from = point_at(curve, bend.begin).at.position.cast<double>();
    const double chord = (point_at(curve, bend.end).at.position.cast<double>() - from).norm();
    const double way = std::min(chord / 2 / math::cos(bounded_half(bend.turn)), options_.radius);
    cuts_.push_back(bend);
    corners_.push_back({bend.begin + way, bend.end - way, bend.middle, bend.turn, span(curve, bend)});
  }
}

/// How far before and after a bend a smooth join spreads t: long enough that |grad t| stays between 1/2 and 2
/// at a right angle, but at most half way to the next bend, and not beyond an end of the stroke.
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
  if (!corner) return 0;
  const double beyond = options_.join == Join::miter    ? miter_reach(corner->turn, options_.radius)
                        : options_.join == Join::smooth ? smooth_reach(corner->turn, options_.radius)
                                                        : 0;
  return beyond > 0 ? 1.1 * beyond + corner_length * options_.radius : 0;
}

const Corner* JoinedLegs::corner_after(std::size_t leg, bool closed) const {
  if (closed && !corners_.empty()) return &corners_[(leg + 1) % corners_.size()];
  return leg < corners_.size() ? &corners_[leg] : nullptr;
}

const Corner* JoinedLegs::corner_before(std::size_t leg, bool closed) const {
  if (closed && !corners_.empty()) return &corners_[leg];
  return leg > 0 ? &corners_[leg - 1] : nullptr;
}

/// Charts a leg. The last leg of a growing stroke continues with the front of the previous call.
void JoinedLegs::chart(const SurfaceCurve& curve, std::size_t leg, const Leg& now, Front& front) {
  const bool whole = cuts_.empty();
  const SurfaceCurve part = whole ? curve : part_of(curve, now.begin, now.end);
  const bool goes_on =
      front_leg_ && !curve.closed && front_leg_->begin == now.begin && front_leg_->reach == now.reach;
  if (!goes_on) front.restart(options_.radius, options_.order, now.reach);
  front_leg_ = now;
  charted_[leg] = chart_with(front, part, now);
  for (LegNode& node : charted_[leg].nodes) node.leg = static_cast<Index>(leg);
  if (options_.cap == Cap::butt)
    std::erase_if(charted_[leg].nodes, [&](const LegNode& node) {
      const double t = node.frame.t - now.begin;
      const bool inner_end = options_.join != Join::overlap && (t < 0 ? now.corner_before : now.corner_after);
      return beyond_end(t, part) && !inner_end;
    });
}

/// Charts a part of the stroke by a front that was restarted for it or holds a chart of it.
JoinedLegs::ChartedLeg JoinedLegs::chart_with(Front& front, const SurfaceCurve& part, const Leg& now) {
  front.update(part);
  settled_ += front.settled();
  pushes_ += front.pushes();
  ChartedLeg charted{now, {}};
  const bool extended = now.reach != Extensions{};
  const std::vector<std::vector<const FrontNode*>> inside = front.inside();
  charted.nodes.reserve(inside[0].size());
  for (const FrontNode* node : inside[0]) {
    ChartFrame frame = node->frame;
    const double half_width = front.half_width(frame.t);
    const StrokePath& path = front.stroke().path;
    const double distance = path.chart_distance(frame.t, static_cast<double>(frame.d));
    if (extended && outside_disc(path, *node, std::max(distance, half_width))) continue;
    frame.t += now.begin;
    charted.nodes.push_back({node->vertex(), 0, frame, half_width, distance});
  }
  return charted;
}

void JoinedLegs::chart_bends(const SurfaceCurve& curve, double unchanged_t) {
  charted_bends_.resize(cuts_.size());
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const double loop = cuts_[i].begin < 0 ? curve.length() : 0;
    const Leg now{cuts_[i].begin + loop, cuts_[i].end + loop, {}, true, true};
    if (!curve.closed && charted_bends_[i].is(now, unchanged_t)) continue;
    if (!bend_front_) bend_front_.emplace(ground_);
    bend_front_->restart(options_.radius, options_.order);
    charted_bends_[i] = chart_with(*bend_front_, part_of(curve, now.begin, now.end), now);
  }
}

/// Appends the nodes of bends that are legs of their own, and at corners the nodes of vertices that the legs
/// leave out.
void JoinedLegs::add_bends(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const {
  const auto add = [&](std::size_t i, const auto& counts) {
    std::ranges::copy_if(charted_bends_[i].nodes, std::back_inserter(nodes), [&](const LegNode& node) {
      return counts(node) && !(options_.cap == Cap::butt && beyond_end(node.frame.t, curve));
    });
  };
  for (std::size_t i = 0; i < cuts_.size(); ++i)
    if (!is_corner(cuts_[i])) add(i, [](const LegNode&) { return true; });
  const std::vector<Index> held = vertices_of(nodes);
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    if (!is_corner(cuts_[i])) continue;
    const std::size_t first = nodes.size();
    add(i, [&](const LegNode& node) { return !std::ranges::binary_search(held, node.vertex); });
    if (options_.join == Join::smooth) smooth_bend(curve, cuts_[i], std::span(nodes).subspan(first));
  }
}

/// The choice at each corner drops the last node of a vertex where several corners lie within the radius and
/// each prefers a node that the next one drops. A vertex under the pen then keeps the node that is nearest to
/// its leg.
void JoinedLegs::keep_last(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const {
  const std::vector<Index> held = vertices_of(nodes);
  std::vector<LegNode> last;
  for (const ChartedLeg& leg : charted_)
    std::ranges::copy_if(leg.nodes, std::back_inserter(last), [&](const LegNode& node) {
      return node.distance <= node.half_width && !std::ranges::binary_search(held, node.vertex) &&
             !(options_.cap == Cap::butt && beyond_end(node.frame.t, curve));
    });
  std::ranges::sort(last, {}, [](const LegNode& node) {
    return std::tuple(node.vertex, node.distance, node.leg, node.frame.t);
  });
  const auto others = std::ranges::unique(last, {}, &LegNode::vertex);
  last.erase(others.begin(), others.end());
  nodes.insert(nodes.end(), last.begin(), last.end());
}

/// At each corner a vertex keeps the node of the leg on whose side of the bisector it lies, which is the node
/// that reaches less far beyond the corner.
void JoinedLegs::select_nodes(std::vector<LegNode>& nodes, bool closed) const {
  std::ranges::sort(nodes, {}, [](const LegNode& n) { return std::tuple(n.vertex, n.leg, n.frame.t); });
  const double near = 4 * options_.radius;
  const auto keeps = [&](const LegNode& node, std::size_t first, std::size_t last, const Corner* corner,
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
  std::vector<LegNode> kept;
  for (std::size_t first = 0; first < nodes.size();) {
    std::size_t last = first;
    while (last < nodes.size() && nodes[last].vertex == nodes[first].vertex) ++last;
    for (std::size_t i = first; i < last; ++i) {
      LegNode node = nodes[i];
      const Corner *before = corner_before(node.leg, closed), *after = corner_after(node.leg, closed);
      if (!keeps(node, first, last, after, true) || !keeps(node, first, last, before, false)) continue;
      if (options_.join == Join::smooth) {
        if (after) smooth_corner(node, *after, true);
        if (before) smooth_corner(node, *before, false);
      }
      kept.push_back(node);
    }
    first = last;
  }
  nodes = std::move(kept);
}

/// Within the bend of a smooth corner the distance and e1 are the bend's own: the circle around the point
/// where the continued legs meet lies off a bend that is rounded. Its far side, which no node of the bend
/// reaches, keeps the distance from the end of the leg and is outside of the stroke.
void JoinedLegs::smooth_corner(LegNode& node, const Corner& corner, bool first_leg) const {
  const ChartedLeg& leg = charted_[node.leg];
  const double beyond = first_leg ? node.frame.t - leg.leg.end : leg.leg.begin - node.frame.t;
  node.frame = smoothed(corner, first_leg, node.frame, ground_[node.vertex].normal);
  if (beyond <= 0) return;
  const ChartedLeg& bend = charted_bends_[static_cast<std::size_t>(&corner - corners_.data())];
  double distance = node.distance;
  for (const LegNode& of_bend : std::ranges::equal_range(bend.nodes, node.vertex, {}, &LegNode::vertex)) {
    if (of_bend.distance >= distance) continue;
    distance = of_bend.distance;
    node.frame.e1 = of_bend.frame.e1;
  }
  node.frame.d = std::copysign(static_cast<float>(distance), node.frame.d);
}

void JoinedLegs::smooth_long_bends(const SurfaceCurve& curve, std::vector<LegNode>& nodes) const {
  for (const Bend& bend : bends_.all())
    if (!is_corner(bend)) smooth_bend(curve, bend, nodes);
}

void JoinedLegs::smooth_bend(const SurfaceCurve& curve, const Bend& bend, std::span<LegNode> nodes) const {
  const double reach = span(curve, bend), length = curve.length();
  for (LegNode& node : nodes) {
    const double t = node.frame.t;
    const double loops = curve.closed ? std::round((t - bend.middle) / length) : 0;
    node.frame.t = smoothed_t(bends_, bend, reach, t - loops * length, static_cast<double>(node.frame.d)) +
                   loops * length;
  }
}

}  // namespace burin
