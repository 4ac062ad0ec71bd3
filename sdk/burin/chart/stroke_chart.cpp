// Stroke charts [R. Schmidt, Stroke Parameterization, 2013]: seeds from the stroke's segments, then the
// front.
#include <burin/base/error.h>
#include <burin/chart/closed_length.h>
#include <burin/chart/front.h>
#include <burin/chart/joined_legs.h>
#include <burin/chart/stroke_chart.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

Chart empty_chart(const SurfaceCurve& curve, std::size_t nodes) {
  Chart chart;
  chart.length = curve.length();
  chart.closed = curve.closed;
  chart.vertex.reserve(nodes);
  chart.sheet.reserve(nodes);
  chart.t.reserve(nodes);
  chart.d.reserve(nodes);
  chart.e1.reserve(nodes);
  chart.stretch.reserve(nodes);
  return chart;
}

/// To be called by rising vertex and t.
void append(Chart& chart, Index vertex, const ChartFrame& frame) {
  const bool same = !chart.vertex.empty() && chart.vertex.back() == vertex;
  chart.sheet.push_back(same ? chart.sheet.back() + 1 : 0);
  chart.vertex.push_back(vertex);
  chart.t.push_back(frame.t);
  chart.d.push_back(frame.d);
  chart.e1.push_back(frame.e1);
  chart.stretch.push_back(frame.stretch);
}

}  // namespace

struct StrokeCharter::Stroke {
  explicit Stroke(const Surface& s) : front(s), legs(s) {}

  Chart update(const SurfaceCurve& curve);
  Chart plain(const SurfaceCurve& curve);
  Chart joined(const SurfaceCurve& curve);

  ChartOptions options;
  Front front;
  JoinedLegs legs;
};

Chart StrokeCharter::Stroke::update(const SurfaceCurve& curve) {
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  return options.join == Join::round && !curve.closed ? plain(curve) : joined(curve);
}

Chart StrokeCharter::Stroke::plain(const SurfaceCurve& curve) {
  front.update(curve);
  const std::vector<const FrontNode*> inside = front.inside();
  Chart chart = empty_chart(curve, inside.size());
  for (const FrontNode* node : inside) {
    if (options.cap == Cap::butt && beyond_end(node->frame.t, curve)) continue;
    append(chart, node->vertex, node->frame);
  }
  return chart;
}

Chart StrokeCharter::Stroke::joined(const SurfaceCurve& curve) {
  std::vector<PlacedNode> nodes;
  legs.place(curve, options, front, nodes);
  if (curve.closed)
    for (PlacedNode& node : nodes) node.frame.t = wrapped_t(node.frame.t, curve.length());
  std::ranges::sort(nodes, {}, [](const PlacedNode& node) { return std::pair(node.vertex, node.frame.t); });
  Chart chart = empty_chart(curve, nodes.size());
  for (const PlacedNode& node : nodes) append(chart, node.vertex, node.frame);
  return chart;
}

StrokeCharter::StrokeCharter(const Surface& surface) : stroke_(std::make_unique<Stroke>(surface)) {}
StrokeCharter::~StrokeCharter() = default;
StrokeCharter::StrokeCharter(StrokeCharter&&) noexcept = default;
StrokeCharter& StrokeCharter::operator=(StrokeCharter&&) noexcept = default;

Chart StrokeCharter::chart(const SurfaceCurve& curve, const ChartOptions& options) {
  const auto radius = static_cast<float>(options.radius);
  if (!std::isfinite(radius) || radius <= 0) {
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
