// Stroke charts [R. Schmidt, Stroke Parameterization, 2013]: seeds from the stroke's segments, then the
// front.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/chart/closed_length.h>
#include <burin/chart/front.h>
#include <burin/chart/joined_legs.h>
#include <burin/chart/stroke_chart.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

Chart chart_of(const SurfaceCurve& curve, std::size_t nodes) {
  Chart chart;
  chart.length = curve.length();
  chart.closed = curve.closed;
  chart.resize(nodes);
  return chart;
}

/// Sets node i. Nodes of one vertex by rising t, and after the nodes before it from `first` on.
void set(Chart& chart, std::size_t first, std::size_t i, Index vertex, const ChartFrame& frame) {
  const bool same = i > first && chart.vertex[i - 1] == vertex;
  chart.set(i, vertex, same ? chart.sheet[i - 1] + 1 : 0, frame);
}

/// Parts of a front that are worth a thread of their own.
std::size_t parts_for(const SurfaceCurve& curve, double radius) {
  // A point of the curve stands for half an edge.
  constexpr double least_nodes = 8000;
  const double points = static_cast<double>(curve.points.size());
  const double edge = 2 * curve.length() / std::max(points, 1.);
  const double nodes = edge > 0 ? points / 2 * (2 * radius / edge) : 0;
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::min(nodes / least_nodes, 1e3)), 1,
                                 thread_count());
}

}  // namespace

struct StrokeCharter::Stroke {
  explicit Stroke(const Surface& s) : front(s), legs(s), live(s.vertex_count()) {}

  void begin(const ChartOptions& with);
  Chart update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts);
  void draw(const SurfaceCurve& curve, std::size_t unchanged);
  bool in_one_piece(const SurfaceCurve& curve) const;
  Chart plain(const SurfaceCurve& curve);
  Chart joined(const SurfaceCurve& curve);

  ChartOptions options;
  Front front;
  JoinedLegs legs;
  LiveChart live;
};

void StrokeCharter::Stroke::begin(const ChartOptions& with) {
  const auto radius = static_cast<float>(with.radius);
  if (!std::isfinite(radius) || radius <= 0)
    throw ContractError("a stroke's radius must be a finite number above 0");
  options = with;
  front.restart(options.radius, options.order);
  live.clear();
}

bool StrokeCharter::Stroke::in_one_piece(const SurfaceCurve& curve) const {
  if (options.radius == 0) throw ContractError("there is no stroke chart to extend");
  if (curve.points.empty()) throw ContractError("a stroke chart needs a curve of at least one point");
  return options.join == Join::round && !curve.closed;
}

Chart StrokeCharter::Stroke::update(const SurfaceCurve& curve, std::size_t unchanged, std::size_t parts) {
  if (!in_one_piece(curve)) return joined(curve);
  front.update(curve, unchanged, parts);
  return plain(curve);
}

void StrokeCharter::Stroke::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  if (!in_one_piece(curve)) return live.assign(joined(curve));
  front.update(curve, unchanged, parts_for(curve, options.radius));
  live.begin_event(curve.length(), false, front.unchanged_t());
  front.for_each_touched([&](Index slot, const FrontNode& node) {
    const bool cut_off = options.cap == Cap::butt && beyond_end(node.frame.t, curve);
    if (node.state == NodeState::inside && !cut_off)
      live.set(slot, node.vertex(), node.frame);
    else
      live.remove(slot);
  });
}

Chart StrokeCharter::Stroke::plain(const SurfaceCurve& curve) {
  std::vector<std::vector<const FrontNode*>> inside = front.inside();
  if (options.cap == Cap::butt)
    for (auto& nodes : inside)
      std::erase_if(nodes, [&](const FrontNode* node) { return beyond_end(node->frame.t, curve); });
  std::vector<std::size_t> begins{0};
  for (const auto& nodes : inside) begins.push_back(begins.back() + nodes.size());
  Chart chart = chart_of(curve, begins.back());
  parallel_blocks(inside.size(), 1, [&](std::size_t part, std::size_t) {
    for (std::size_t i = 0; i < inside[part].size(); ++i)
      set(chart, begins[part], begins[part] + i, inside[part][i]->vertex(), inside[part][i]->frame);
  });
  return chart;
}

Chart StrokeCharter::Stroke::joined(const SurfaceCurve& curve) {
  std::vector<PlacedNode> nodes;
  legs.place(curve, options, front, nodes);
  if (curve.closed)
    for (PlacedNode& node : nodes) node.frame.t = wrapped_t(node.frame.t, curve.length());
  std::ranges::sort(nodes, {}, [](const PlacedNode& node) { return std::pair(node.vertex, node.frame.t); });
  Chart chart = chart_of(curve, nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) set(chart, 0, i, nodes[i].vertex, nodes[i].frame);
  return chart;
}

StrokeCharter::StrokeCharter(const Surface& surface) : stroke_(std::make_unique<Stroke>(surface)) {}
StrokeCharter::~StrokeCharter() = default;
StrokeCharter::StrokeCharter(StrokeCharter&&) noexcept = default;
StrokeCharter& StrokeCharter::operator=(StrokeCharter&&) noexcept = default;

Chart StrokeCharter::chart(const SurfaceCurve& curve, const ChartOptions& options) {
  stroke_->begin(options);
  return stroke_->update(curve, 0, parts_for(curve, options.radius));
}

Chart StrokeCharter::extend(const SurfaceCurve& curve, std::size_t unchanged) {
  return stroke_->update(curve, unchanged, 1);
}

void StrokeCharter::begin(const ChartOptions& options) { stroke_->begin(options); }

const LiveChart& StrokeCharter::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  stroke_->draw(curve, unchanged);
  return stroke_->live;
}

const LiveChart& StrokeCharter::live() const { return stroke_->live; }
std::uint64_t StrokeCharter::settled() const { return stroke_->front.settled(); }
std::uint64_t StrokeCharter::pushes() const { return stroke_->front.pushes(); }

}  // namespace burin
