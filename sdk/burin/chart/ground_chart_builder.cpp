// Computes stroke charts on one ground [R. Schmidt, Stroke Parameterization, 2013]: by one front for open
// strokes with round joins, by legs (leg_charts.h, vertex_join.h) for all others. A chart of n nodes costs
// O(n log n).
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/chart/ground_chart_builder.h>
#include <burin/chart/path/closed_length.h>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

Chart chart_of(const SurfaceCurve& curve, std::size_t nodes) {
  Chart chart;
  chart.length = curve.length();
  chart.closed = curve.closed;
  chart.resize(nodes);
  return chart;
}

/// Sets node i of the chart and its sheet. Nodes must be set in ascending order of (vertex, t), starting with
/// node `first`.
void set(Chart& chart, std::size_t first, std::size_t i, Index vertex, const ChartFrame& frame,
         const Vec3f& normal) {
  const bool same = i > first && chart.vertex[i - 1] == vertex;
  chart.set(i, vertex, same ? chart.sheet[i - 1] + 1 : 0, frame, normal);
}

bool beyond_end(double t, const SurfaceCurve& curve) {
  return beyond_ends(t, curve.length(), curve.closed) > 0;
}

}  // namespace

std::size_t parts_for(const SurfaceCurve& curve, double radius) {
  // Points of the curve are about half an edge apart.
  constexpr double least_nodes = 8000;
  const double points = static_cast<double>(curve.points.size());
  const double edge = 2 * curve.length() / std::max(points, 1.);
  const double nodes = edge > 0 ? points / 2 * (2 * radius / edge) : 0;
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::min(nodes / least_nodes, 1e3)), 1,
                                 own_thread_count());
}

void GroundChartBuilder::begin(const ChartOptions& options, double stroke_radius) {
  options_ = options;
  stroke_radius_ = stroke_radius;
  front_.restart(options_.radius, options_.order);
  legs_.reset();
  joined_.reset();
  live_.clear();
}

/// A closed stroke that is opened again starts anew.
void GroundChartBuilder::goes_in_one_piece() {
  if (legs_) begin(options_, stroke_radius_);
}

void GroundChartBuilder::expect_curve(const SurfaceCurve& curve) const {
  if (options_.radius == 0) throw ContractError("there is no stroke chart to extend");
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
}

Chart GroundChartBuilder::update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts) {
  expect_curve(curve);
  if (!in_one_piece(curve)) return draw_joined(curve, unchanged).sorted();
  goes_in_one_piece();
  front_.update(curve, unchanged, parts);
  return plain(curve);
}

const LiveChart& GroundChartBuilder::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  expect_curve(curve);
  if (!in_one_piece(curve)) return draw_joined(curve, unchanged);
  goes_in_one_piece();
  front_.update(curve, unchanged, parts_for(curve, options_.radius));
  live_.begin_event(curve.length(), false, front_.unchanged_t());
  front_.for_each_touched([&](Index slot, const FrontNode& node) {
    const bool cut_off = options_.cap == Cap::butt && beyond_end(node.frame.t, curve);
    if (node.state == NodeState::inside && !cut_off)
      live_.set(slot, node.vertex(), node.frame, node.normal, node.contested);
    else
      live_.remove(slot);
  });
  return live_;
}

Chart GroundChartBuilder::plain(const SurfaceCurve& curve) {
  std::vector<std::vector<const FrontNode*>> inside = front_.inside();
  if (options_.cap == Cap::butt)
    for (auto& nodes : inside)
      std::erase_if(nodes, [&](const FrontNode* node) { return beyond_end(node->frame.t, curve); });
  std::vector<std::size_t> begins{0};
  for (const auto& nodes : inside) begins.push_back(begins.back() + nodes.size());
  Chart chart = chart_of(curve, begins.back());
  parallel_blocks(inside.size(), 1, [&](std::size_t part, std::size_t) {
    for (std::size_t i = 0; i < inside[part].size(); ++i)
      set(chart, begins[part], begins[part] + i, inside[part][i]->vertex(), inside[part][i]->frame,
          inside[part][i]->normal);
  });
  return chart;
}

const LegCharts& GroundChartBuilder::draw_legs(const SurfaceCurve& curve, std::size_t unchanged) {
  expect_curve(curve);
  if (!legs_) {
    ChartOptions of_stroke = options_;
    of_stroke.radius = stroke_radius_;
    legs_.emplace(ground_, of_stroke, options_.radius);
    unchanged = 0;
  }
  legs_->update(curve, unchanged, front_);
  return *legs_;
}

const LiveChart& GroundChartBuilder::draw_joined(const SurfaceCurve& curve, std::size_t unchanged) {
  const LegCharts& legs = draw_legs(curve, unchanged);
  if (!joined_)
    joined_.emplace(nullptr, *ground_.surface(), options_.radius, static_cast<Index>(live_.nodes().size()));
  joined_->update(legs, curve, options_, live_);
  return live_;
}

}  // namespace burin
