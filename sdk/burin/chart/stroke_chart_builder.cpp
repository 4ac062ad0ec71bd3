// Computes stroke charts [R. Schmidt, Stroke Parameterization, 2013]: propagated over the vertices
// themselves, or over the nodes of a base surface and interpolated from there to the vertices
// (chart_transfer.h, leg_transfer.h).
#include <burin/base/error.h>
#include <burin/chart/ground_chart_builder.h>
#include <burin/chart/path/curve_parts.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/chart/transfer/chart_transfer.h>
#include <burin/chart/transfer/leg_transfer.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

struct StrokeChartBuilder::Stroke {
  Stroke(const Surface& s, const SurfaceLevels* levels) : surface(s), live(s.vertex_count()) {
    if (levels) base.emplace(s, *levels);
  }

  void begin(const ChartOptions& with);
  BaseSurface* base_for(double radius, double follow, bool fine);
  void prepare(const SurfaceCurve& curve, std::size_t unchanged);
  const LiveChart& draw(const SurfaceCurve& curve, std::size_t unchanged);
  bool on_base() const { return transferred.has_value(); }
  void follow(const SurfaceCurve& curve);
  const SurfaceCurve& widened(const SurfaceCurve& curve);
  GroundChartBuilder& own();
  GroundChartBuilder& builder() { return on_base() ? *of_base : own(); }

  const Surface& surface;
  ChartOptions options;
  std::optional<GroundChartBuilder>
      of_surface;  ///< created for the first stroke that runs on the surface itself
  std::optional<BaseSurface> base;
  std::optional<GroundChartBuilder> of_base;
  Index of_base_nodes = 0;  ///< node count for which of_base was created; levels differ in it
  std::optional<TransferredStroke> transferred;  ///< set while the stroke runs on the base surface
  std::optional<ChartTransfer> transfer;         ///< of a stroke in one piece
  std::optional<LegTransfer> leg_transfer;       ///< of a stroke in legs
  SurfaceCurve with_margin;      ///< the last curve whose width varies, as the base chart sees it
  BaseSurface::Ball prepared{};  ///< the last ball in which base nodes were computed
  LiveChart live;                ///< the vertices' chart of a stroke on the base surface
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
  if (!base_for(with.radius, with.follow, with.fine)) return own().begin(with);
  if (of_base_nodes != base->node_count()) of_base.emplace(ChartGround(*base));
  of_base_nodes = base->node_count();
  transferred = {with.radius, with.radius + transfer_margin * base->spacing(), with.cap};
  ChartOptions of_nodes = with;
  of_nodes.radius = transferred->base_radius;
  of_nodes.cap = Cap::round;
  of_base->begin(of_nodes, with.radius);
  live.clear();
  prepared = {Vec3f::Zero(), -1, no_index};
}

BaseSurface* StrokeChartBuilder::Stroke::base_for(double radius, double follow, bool fine) {
  transferred.reset();
  transfer.reset();
  leg_transfer.reset();
  const double scale = radius * (1 - follow);
  return base && scale > 0 && base->set_radius(scale, fine) ? &*base : nullptr;
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

/// The curve with widths that make the base chart wider than the stroke by the same margin everywhere. Valid
/// until the next call, and no longer than `curve`.
const SurfaceCurve& StrokeChartBuilder::Stroke::widened(const SurfaceCurve& curve) {
  if (has_uniform_width(curve)) return curve;
  with_margin = curve;
  const auto [radius, base_radius, cap] = *transferred;
  for (CurvePoint& point : with_margin.points)
    point.width =
        static_cast<float>((radius * static_cast<double>(point.width) + base_radius - radius) / base_radius);
  return with_margin;
}

/// Goes over to the kind of transfer that the curve needs. A stroke changes its kind when it is closed; the
/// slots of the other kind are not used again.
void StrokeChartBuilder::Stroke::follow(const SurfaceCurve& curve) {
  const Index first_slot = static_cast<Index>(live.nodes().size());
  if (of_base->in_one_piece(curve)) {
    leg_transfer.reset();
    if (!transfer) transfer.emplace(*base, surface, *transferred, first_slot);
  } else {
    transfer.reset();
    if (!leg_transfer) leg_transfer.emplace(&*base, surface, options.radius, first_slot);
  }
}

const LiveChart& StrokeChartBuilder::Stroke::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  if (!on_base()) return own().draw(curve, unchanged);
  if (!curve.points.empty()) prepare(curve, unchanged);
  follow(curve);
  const SurfaceCurve& on_base_nodes = widened(curve);
  if (transfer)
    transfer->update(of_base->draw(on_base_nodes, unchanged), of_base->stroke(), curve, live);
  else
    leg_transfer->update(of_base->draw_legs(on_base_nodes, unchanged), curve, options, live);
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
BaseSurface* StrokeChartBuilder::base_for(double radius, double follow, bool fine) {
  return stroke_->base_for(radius, follow, fine);
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
