// Charts each leg of a stroke and each bend between two legs by a front. An event costs O(log n) for each
// node that it changes; the last leg of a growing stroke goes on with its front, others are charted once.
#include <burin/chart/joins/leg_charts.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace burin {
namespace {

/// Whether a node lies outside of the disc, of the usual size, around its foot. The discs of extended legs
/// are wider and let false frames pass where the surface folds.
bool outside_disc(const StrokePath& path, const FrontNode& node, double half_width) {
  const double t = node.frame.t, d = static_cast<double>(node.frame.d), distance = path.chart_distance(t, d);
  return distance + path.excess(t, d, node.position) > disc_over_width * std::max(distance, half_width);
}

/// The arc length up to which a curve is known to be as before, minus infinity for no arc length.
double unchanged_below(const SurfaceCurve& curve, std::size_t unchanged) {
  return unchanged > 0 && !curve.closed ? curve.points[unchanged - 1].t
                                        : -std::numeric_limits<double>::infinity();
}

}  // namespace

void LegCharts::update(const SurfaceCurve& curve, std::size_t unchanged, Front& front) {
  for (const Index local : changed_) has_changed_[local] = 0;
  changed_.clear();
  settled_ = pushes_ = 0;
  const double unchanged_t = unchanged_below(curve, unchanged);
  same_below_ = stroke_.update(curve, unchanged);
  const auto legs = static_cast<Index>(stroke_.legs().size()),
             cuts = static_cast<Index>(stroke_.cuts().size());
  drop_parts(legs, cuts);
  for (Index leg = 0; leg < legs; ++leg) {
    const std::optional<Leg>& before = part(part_of_leg(leg)).leg;
    const Leg& now = stroke_.legs()[leg];
    if (before != now || now.end >= unchanged_t) chart_leg(curve, leg, unchanged, front);
  }
  for (Index cut = 0; cut < cuts; ++cut) {
    const Leg now = stroke_.bend(cut);
    if (part(part_of_cut(cut)).leg != now || now.end >= unchanged_t) chart_bend(curve, cut);
  }
}

LegCharts::Part& LegCharts::part(Index number) {
  if (number >= parts_.size()) parts_.resize(number + 1);
  return parts_[number];
}

/// Discards the charts of parts that the stroke has no more.
void LegCharts::drop_parts(std::size_t legs, std::size_t cuts) {
  for (Index number = 0; number < parts_.size(); ++number)
    if (number / 2 >= (number % 2 == 0 ? legs : cuts)) clear_part(number);
}

/// Charts a leg. The last leg of a growing stroke goes on with the front of the previous call.
void LegCharts::chart_leg(const SurfaceCurve& curve, Index leg, std::size_t unchanged, Front& front) {
  const Index number = part_of_leg(leg);
  const Leg& now = stroke_.legs()[leg];
  const std::optional<Leg> before = part(number).leg;
  const bool goes_on = front_leg_ == leg && before && !curve.closed && !front.stroke().curve.closed &&
                       before->begin == now.begin && before->reach == now.reach &&
                       now.begin < unchanged_below(curve, unchanged);
  if (!goes_on) {
    front.restart(charted_radius_, order_, now.reach);
    clear_part(number);
    at_slot_.clear();
    front_curve_.points.clear();
  }
  front_leg_ = leg;
  if (stroke_.cuts().empty()) {
    const bool was_whole = front_curve_.points.empty();
    front_curve_.points.clear();
    front.update(curve, was_whole ? unchanged : 0);
  } else if (front_curve_.points.empty()) {
    front_curve_ = part_of(curve, now.begin, now.end);
    front.update(front_curve_);
  } else {
    const std::size_t kept =
        update_part(front_curve_, curve, now.begin, now.end, unchanged_below(curve, unchanged));
    front.update(front_curve_, kept);
  }
  follow(front, number, now);
}

void LegCharts::chart_bend(const SurfaceCurve& curve, Index cut) {
  const Leg now = stroke_.bend(cut);
  clear_part(part_of_cut(cut));
  if (!bend_front_) bend_front_.emplace(ground_);
  bend_front_->restart(charted_radius_, order_);
  bend_front_->update(part_of(curve, now.begin, now.end));
  follow(*bend_front_, part_of_cut(cut), now);
}

void LegCharts::clear_part(Index number) {
  Part& cleared = part(number);
  for (const Index local : cleared.vertices)
    if (std::erase_if(nodes_[local], [&](const LegNode& node) { return node.part == number; }) > 0)
      note_change(local);
  cleared.vertices.clear();
  cleared.leg.reset();
}

/// Takes over what the last update of a front changed.
void LegCharts::follow(const Front& front, Index number, const Leg& now) {
  settled_ += front.settled();
  pushes_ += front.pushes();
  part(number).leg = now;
  const bool extended = now.reach != Extensions{};
  const StrokePath& path = front.stroke().path;
  front.for_each_touched([&](Index slot, const FrontNode& node) {
    LegNode of_leg{.part = number, .slot = slot, .frame = node.frame, .ray = {}};
    const double t = node.frame.t;
    if (node.state != NodeState::inside || (extended && outside_disc(path, node, front.half_width(t))))
      return remove(number, slot);
    of_leg.ray = path.ray(t, static_cast<double>(node.frame.d));
    of_leg.frame.t += now.begin;
    set(of_leg, node.vertex());
  });
}

void LegCharts::set(const LegNode& node, Index vertex) {
  Index local = local_.find(vertex);
  if (local == no_index) {
    local = local_.insert(vertex);
    nodes_.emplace_back();
    has_changed_.push_back(0);
  }
  if (!node.is_of_bend()) {
    if (node.slot >= at_slot_.size()) at_slot_.resize(node.slot + 1, no_index);
    if (at_slot_[node.slot] != local) remove(node.part, node.slot);
    at_slot_[node.slot] = local;
  }
  std::vector<LegNode>& nodes = nodes_[local];
  const auto at = std::ranges::find_if(
      nodes, [&](const LegNode& other) { return other.part == node.part && other.slot == node.slot; });
  if (at == nodes.end()) {
    nodes.push_back(node);
    part(node.part).vertices.push_back(local);
  } else if (at->frame == node.frame && at->ray == node.ray) {
    return;
  } else {
    *at = node;
  }
  note_change(local);
}

/// Takes the node of a slot of the caller's front away, if it holds one.
void LegCharts::remove(Index number, Index slot) {
  if (number % 2 == 1 || slot >= at_slot_.size() || at_slot_[slot] == no_index) return;
  const Index local = std::exchange(at_slot_[slot], no_index);
  std::erase_if(nodes_[local], [&](const LegNode& node) { return node.part == number && node.slot == slot; });
  note_change(local);
}

void LegCharts::note_change(Index local) {
  if (has_changed_[local]) return;
  has_changed_[local] = 1;
  changed_.push_back(local);
}

}  // namespace burin
