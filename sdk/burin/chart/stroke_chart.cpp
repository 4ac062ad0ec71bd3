// Stroke charts [R. Schmidt, Stroke Parameterization, 2013]: seeds from the stroke's segments, then the
// front.
#include <burin/base/error.h>
#include <burin/chart/front.h>
#include <burin/chart/stroke_chart.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

struct StrokeCharter::Stroke {
  explicit Stroke(const Surface& s) : surface(&s), front(s) {}

  Chart update(const SurfaceCurve& curve);
  Chart collect(const SurfaceCurve& curve) const;

  const Surface* surface;
  ChartOptions options;
  Front front;
};

Chart StrokeCharter::Stroke::update(const SurfaceCurve& curve) {
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  front.update(curve);
  return collect(curve);
}

Chart StrokeCharter::Stroke::collect(const SurfaceCurve& curve) const {
  std::vector<Index> nodes(front.inside().begin(), front.inside().end());
  if (options.cap == Cap::butt && !curve.closed) {
    std::erase_if(nodes, [&](Index node) {
      const double t = front.frame(node).t;
      return t < 0 || t > curve.length();
    });
  }
  if (curve.closed) {
    std::ranges::sort(nodes, {},
                      [&](Index node) { return std::pair(front.vertex(node), front.frame(node).t); });
  }
  Chart chart;
  chart.length = curve.length();
  chart.closed = curve.closed;
  for (auto* numbers : {&chart.d, &chart.stretch}) numbers->reserve(nodes.size());
  chart.vertex.reserve(nodes.size());
  chart.sheet.reserve(nodes.size());
  chart.t.reserve(nodes.size());
  chart.e1.reserve(nodes.size());
  for (const Index node : nodes) {
    const ChartFrame& frame = front.frame(node);
    const Index vertex = front.vertex(node);
    chart.sheet.push_back(!chart.vertex.empty() && chart.vertex.back() == vertex ? chart.sheet.back() + 1
                                                                                 : 0);
    chart.vertex.push_back(vertex);
    chart.t.push_back(frame.t);
    chart.d.push_back(frame.d);
    chart.e1.push_back(frame.e1);
    chart.stretch.push_back(frame.stretch);
  }
  return chart;
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
