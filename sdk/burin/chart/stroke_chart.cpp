// Stroke charts [R. Schmidt, Stroke Parameterization, 2013]: seeds from the stroke's segments, then the
// front.
#include <burin/base/error.h>
#include <burin/chart/front.h>
#include <burin/chart/joined_legs.h>
#include <burin/chart/stroke_chart.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

Chart make_chart(const std::vector<PlacedNode>& nodes, const SurfaceCurve& curve) {
  Chart chart;
  chart.length = curve.length();
  chart.closed = curve.closed;
  chart.vertex.reserve(nodes.size());
  chart.sheet.reserve(nodes.size());
  chart.t.reserve(nodes.size());
  chart.d.reserve(nodes.size());
  chart.e1.reserve(nodes.size());
  chart.stretch.reserve(nodes.size());
  for (const auto& [vertex, leg, frame] : nodes) {
    const bool same = !chart.vertex.empty() && chart.vertex.back() == vertex;
    chart.sheet.push_back(same ? chart.sheet.back() + 1 : 0);
    chart.vertex.push_back(vertex);
    chart.t.push_back(frame.t);
    chart.d.push_back(frame.d);
    chart.e1.push_back(frame.e1);
    chart.stretch.push_back(frame.stretch);
  }
  return chart;
}

double around(double t, double length) {
  const double rest = t - length * std::floor(t / length);
  return rest < length ? rest : 0;
}

}  // namespace

struct StrokeCharter::Stroke {
  explicit Stroke(const Surface& s) : front(s), legs(s) {}

  Chart update(const SurfaceCurve& curve);
  void place(const SurfaceCurve& curve);

  ChartOptions options;
  Front front;
  JoinedLegs legs;
  std::vector<PlacedNode> nodes;  ///< of the chart being made
};

Chart StrokeCharter::Stroke::update(const SurfaceCurve& curve) {
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  nodes.clear();
  if (options.join == Join::round)
    place(curve);
  else
    legs.place(curve, options, front, nodes);
  if (curve.closed || options.join != Join::round) {
    if (curve.closed)
      for (PlacedNode& node : nodes) node.frame.t = around(node.frame.t, curve.length());
    std::ranges::sort(nodes, {}, [](const PlacedNode& node) { return std::pair(node.vertex, node.frame.t); });
  }
  return make_chart(nodes, curve);
}

void StrokeCharter::Stroke::place(const SurfaceCurve& curve) {
  front.update(curve);
  for (const Index node : front.inside()) {
    const ChartFrame& frame = front.frame(node);
    if (options.cap == Cap::butt && beyond_end(frame.t, curve)) continue;
    nodes.push_back({front.vertex(node), 0, frame});
  }
}

StrokeCharter::StrokeCharter(const Surface& surface) : stroke_(std::make_unique<Stroke>(surface)) {}
StrokeCharter::~StrokeCharter() = default;
StrokeCharter::StrokeCharter(StrokeCharter&&) noexcept = default;
StrokeCharter& StrokeCharter::operator=(StrokeCharter&&) noexcept = default;

Chart StrokeCharter::chart(const SurfaceCurve& curve, const ChartOptions& options) {
  if (!std::isfinite(options.radius) || options.radius <= 0) {
    throw ContractError("a stroke's radius must be a finite number above 0");
  }
  stroke_->options = options;
  stroke_->front.restart(options.radius, options.order);
  return stroke_->update(curve);
}

Chart StrokeCharter::extend(const SurfaceCurve& curve) {
  if (stroke_->options.radius == 0) throw ContractError("there is no stroke chart to extend");
  return stroke_->update(curve);
}

}  // namespace burin
