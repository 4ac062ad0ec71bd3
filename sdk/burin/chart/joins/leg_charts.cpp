// Charts each leg of a stroke and each bend between two legs by a front. For n nodes in total it costs
// O(n log n); legs that did not change since the last update are not charted again.
#include <burin/chart/joins/leg_charts.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <tuple>

namespace burin {
namespace {

/// Whether a node lies outside of the disc, of the usual size, around its foot. The discs of extended legs
/// are wider and let false frames pass where the surface folds.
bool outside_disc(const StrokePath& path, const FrontNode& node, double half_width) {
  const double t = node.frame.t, d = static_cast<double>(node.frame.d), distance = path.chart_distance(t, d);
  return distance + path.excess(t, d, node.position) > disc_over_width * std::max(distance, half_width);
}

}  // namespace

void LegCharts::begin(double radius, int order) {
  radius_ = radius;
  order_ = order;
  legs_.clear();
  bends_.clear();
  front_leg_.reset();
}

void LegCharts::update(const SurfaceCurve& curve, double unchanged_t, const StrokeLegs& stroke,
                       Front& front) {
  settled_ = pushes_ = 0;
  const std::span<const Leg> legs = stroke.legs();
  const std::span<const SpreadBend> cuts = stroke.cuts();
  legs_.resize(legs.size());
  bends_.resize(cuts.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!curve.closed && legs_[i].is(legs[i], unchanged_t)) continue;
    chart_leg(cuts.empty() ? curve : part_of(curve, legs[i].begin, legs[i].end), legs[i], curve.closed, front,
              legs_[i]);
  }
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Leg bend = stroke.bend(i);
    if (curve.closed || !bends_[i].is(bend, unchanged_t))
      chart_bend(part_of(curve, bend.begin, bend.end), bend, bends_[i]);
  }
}

/// Charts a leg. The last leg of a growing stroke continues with the front of the previous call.
void LegCharts::chart_leg(const SurfaceCurve& part, const Leg& now, bool closed, Front& front,
                          Charted& charted) {
  const bool goes_on =
      front_leg_ && !closed && front_leg_->begin == now.begin && front_leg_->reach == now.reach;
  if (!goes_on) front.restart(radius_, order_, now.reach);
  front_leg_ = now;
  chart_with(front, part, now, charted);
}

void LegCharts::chart_bend(const SurfaceCurve& part, const Leg& now, Charted& charted) {
  if (!bend_front_) bend_front_.emplace(ground_);
  bend_front_->restart(radius_, order_);
  chart_with(*bend_front_, part, now, charted);
}

/// Charts a part of the stroke by a front that was restarted for it or holds a chart of it.
void LegCharts::chart_with(Front& front, const SurfaceCurve& part, const Leg& now, Charted& charted) {
  front.update(part);
  settled_ += front.settled();
  pushes_ += front.pushes();
  charted.leg = now;
  charted.nodes.clear();
  const bool extended = now.reach != Extensions{};
  const StrokePath& path = front.stroke().path;
  const std::vector<std::vector<const FrontNode*>> inside = front.inside();
  for (const FrontNode* node : inside[0]) {
    ChartFrame frame = node->frame;
    if (extended && outside_disc(path, *node, front.half_width(frame.t))) continue;
    const DistanceRay ray = path.ray(frame.t, static_cast<double>(frame.d));
    frame.t += now.begin;
    charted.nodes.push_back({.vertex = node->vertex(), .leg = 0, .frame = frame, .ray = ray});
  }
}

std::vector<LegNode> LegCharts::nodes() const {
  std::vector<LegNode> all;
  Index leg = 0;
  for (const std::vector<Charted>* charts : {&legs_, &bends_})
    for (const Charted& charted : *charts) {
      for (const LegNode& node : charted.nodes) all.emplace_back(node).leg = leg;
      ++leg;
    }
  std::ranges::sort(all, {},
                    [](const LegNode& node) { return std::tuple(node.vertex, node.leg, node.frame.t); });
  return all;
}

}  // namespace burin
