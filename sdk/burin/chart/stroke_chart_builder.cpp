// Computes stroke charts [R. Schmidt, Stroke Parameterization, 2013]: propagated over the vertices
// themselves, or over the nodes of a base surface and interpolated from there to the vertices
// (chart_transfer.h).
#include <burin/base/error.h>
#include <burin/chart/ground_chart_builder.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/chart/transfer/chart_transfer.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

struct StrokeChartBuilder::Stroke {
  Stroke(const Surface& s, const SurfaceLevels* levels) : surface(s), live(s.vertex_count()) {
    if (levels) base.emplace(s, *levels);
  }

  void begin(const ChartOptions& with);
  BaseSurface* base_for(double radius, double follow);
  void prepare(const SurfaceCurve& curve, std::size_t unchanged);
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged);
  bool on_base() const { return transfer.has_value(); }
  GroundChartBuilder& own();
  GroundChartBuilder& builder() { return on_base() ? *of_base : own(); }

  const Surface& surface;
  ChartOptions options;
  std::optional<GroundChartBuilder>
      of_surface;  ///< created for the first stroke that runs on the surface itself
  std::optional<BaseSurface> base;
  std::optional<GroundChartBuilder> of_base;
  Index of_base_nodes = 0;                ///< node count for which of_base was created; levels differ in it
  std::optional<ChartTransfer> transfer;  ///< set while the stroke runs on the base surface
  BaseSurface::Ball prepared{};           ///< the last ball in which base nodes were computed
  LiveChart live;                         ///< the vertices' chart of a stroke on the base surface
};

GroundChartBuilder& StrokeChartBuilder::Stroke::own() {
  if (!of_surface) of_surface.emplace(ChartGround(surface));
  return *of_surface;
}

void StrokeChartBuilder::Stroke::begin(const ChartOptions& with) {
  const auto radius = static_cast<float>(with.radius);
  if (!std::isfinite(radius) || radius <= 0)
    throw ContractError("a stroke's radius must be a finite number above 0");
  options = with;
  if (!base_for(with.radius, with.follow)) return own().begin(with);
  if (of_base_nodes != base->node_count()) of_base.emplace(ChartGround(*base));
  of_base_nodes = base->node_count();
  ChartOptions wider = with;
  wider.radius += transfer_margin * base->spacing();
  wider.cap = Cap::round;
  of_base->begin(wider);
  live.clear();
  prepared = {Vec3f::Zero(), -1, no_index};
  transfer.emplace(*base, surface, TransferredStroke{with.radius, wider.radius, with.cap});
}

BaseSurface* StrokeChartBuilder::Stroke::base_for(double radius, double follow) {
  transfer.reset();
  const double scale = radius * (1 - follow);
  return base && scale > 0 && base->set_radius(scale) ? &*base : nullptr;
}

/// Computes on all threads the base nodes that the front will read one by one, and some beyond, so that most
/// points of the curve need no preparation.
void StrokeChartBuilder::Stroke::prepare(const SurfaceCurve& curve, std::size_t unchanged) {
  const double around_front = (transfer_margin + 1) * base->spacing(), beyond = 2 * base->spacing();
  std::vector<BaseSurface::Ball> balls;
  for (std::size_t i = std::min(unchanged, curve.points.size() - 1); i < curve.points.size(); ++i) {
    const CurvePoint& point = curve.points[i];
    const double reach = options.radius * static_cast<double>(point.width) + around_front;
    const auto way = static_cast<double>((point.at.position - prepared.middle).norm());
    if (way + reach <= prepared.radius) continue;
    prepared = {point.at.position, reach + beyond, point.at.corners[0]};
    balls.push_back(prepared);
  }
  base->prepare(balls);
}

const LiveChart& StrokeChartBuilder::Stroke::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  if (!on_base()) return own().draw(curve, unchanged);
  if (!curve.points.empty()) prepare(curve, unchanged);
  const LiveChart& nodes = of_base->draw(transfer->widened(curve), unchanged);
  transfer->update(nodes, of_base->stroke(), curve, live);
  return live;
}

StrokeChartBuilder::StrokeChartBuilder(const Surface& surface, const SurfaceLevels* levels)
    : stroke_(std::make_unique<Stroke>(surface, levels)) {}
StrokeChartBuilder::~StrokeChartBuilder() = default;
StrokeChartBuilder::StrokeChartBuilder(StrokeChartBuilder&&) noexcept = default;
StrokeChartBuilder& StrokeChartBuilder::operator=(StrokeChartBuilder&&) noexcept = default;

Chart StrokeChartBuilder::chart(const SurfaceCurve& curve, const ChartOptions& options) {
  stroke_->begin(options);
  if (stroke_->on_base()) return stroke_->draw(curve, 0).sorted();
  return stroke_->own().update(curve, 0, parts_for(curve, options.radius));
}

Chart StrokeChartBuilder::extend(const SurfaceCurve& curve, std::size_t unchanged) {
  if (stroke_->on_base()) return stroke_->draw(curve, unchanged).sorted();
  return stroke_->own().update(curve, unchanged, 1);
}

void StrokeChartBuilder::begin(const ChartOptions& options) { stroke_->begin(options); }

const LiveChart& StrokeChartBuilder::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  return stroke_->draw(curve, unchanged);
}

BaseSurface* StrokeChartBuilder::base() { return stroke_->on_base() ? &*stroke_->base : nullptr; }
BaseSurface* StrokeChartBuilder::base_for(double radius, double follow) {
  return stroke_->base_for(radius, follow);
}
void StrokeChartBuilder::moved(std::span<const Index> vertices, double distance) {
  if (stroke_->base) stroke_->base->forget(vertices, distance);
}
const LiveChart& StrokeChartBuilder::live() const {
  return stroke_->on_base() ? stroke_->live : stroke_->own().live();
}
std::uint64_t StrokeChartBuilder::settled() const { return stroke_->builder().settled(); }
std::uint64_t StrokeChartBuilder::pushes() const { return stroke_->builder().pushes(); }

}  // namespace burin
