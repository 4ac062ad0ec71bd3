// Stroke charts [R. Schmidt, Stroke Parameterization, 2013]: seeds from the stroke's segments, then the
// front.
#include <burin/base/error.h>
#include <burin/chart/front.h>
#include <burin/chart/stroke_chart.h>

#include <cmath>

namespace burin {

struct StrokeCharter::Stroke {
  explicit Stroke(const Surface& s) : surface(&s), front(s), found(s.vertex_count()) {}

  Chart update(const SurfaceCurve& curve);
  Chart collect(double length) const;

  const Surface* surface;
  ChartOptions options;
  Front front;
  VertexNodes found;  ///< scratch of find_seeds
};

Chart StrokeCharter::Stroke::update(const SurfaceCurve& curve) {
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  front.update(find_seeds(*surface, curve, options.radius, found), curve.length());
  return collect(curve.length());
}

Chart StrokeCharter::Stroke::collect(double length) const {
  Chart chart;
  chart.vertex.reserve(front.inside().size());
  chart.t.reserve(front.inside().size());
  chart.d.reserve(front.inside().size());
  chart.e1.reserve(front.inside().size());
  for (const Index node : front.inside()) {
    const ChartFrame& frame = front.frame(node);
    if (options.cap == Cap::butt && (frame.t < 0 || frame.t > length)) continue;
    chart.vertex.push_back(front.vertex(node));
    chart.t.push_back(frame.t);
    chart.d.push_back(frame.d);
    chart.e1.push_back(frame.e1);
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
