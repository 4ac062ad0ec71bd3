// Charts a stroke as a row of dabs (dab.h). An event costs the dabs that the changed end of the curve removes
// and adds.
#include <burin/chart/dabs/dab_transfer.h>
#include <burin/chart/dabs/live_dabs.h>
#include <burin/chart/path/curve_parts.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double everywhere = -std::numeric_limits<double>::infinity();

/// The distance between dabs along the curve; a closed curve is divided evenly.
double even_spacing(const SurfaceCurve& curve, double spacing) {
  if (!curve.closed) return spacing;
  return curve.length() / std::max(1.0, std::round(curve.length() / spacing));
}

std::size_t dab_count(const SurfaceCurve& curve, double spacing) {
  const double gaps = curve.length() / spacing;
  return static_cast<std::size_t>(curve.closed ? std::round(gaps) : std::floor(gaps) + 1);
}

}  // namespace

LiveDabs::LiveDabs(const Surface& surface, const Picker& picker)
    : surface_(&surface), picker_(&picker), builder_(surface), live_(surface.vertex_count()) {}

void LiveDabs::begin(double radius, double spacing, BaseSurface* base) {
  radius_ = radius;
  spacing_ = spacing;
  live_.clear();
  along_.clear();
  dabs_.clear();
  vacant_.clear();
  closed_ = false;
  base_ = base;
  if (base_) of_base_.emplace(ChartGround(*base_));
}

const LiveChart& LiveDabs::draw(const SurfaceCurve& curve, std::size_t unchanged) {
  const bool same_spacing = curve.closed == closed_ && !closed_;
  const double from = same_spacing && unchanged > 0 ? curve.points[unchanged - 1].t : everywhere;
  closed_ = curve.closed;
  settled_ = 0;
  live_.begin_event(curve.length(), curve.closed, from);
  take_back_from(from);
  const double spacing = even_spacing(curve, spacing_);
  const std::size_t count = dab_count(curve, spacing);
  while (dabs_.size() < count) put(point_at(curve, static_cast<double>(dabs_.size()) * spacing));
  return live_;
}

void LiveDabs::take_back_from(double t) {
  while (!dabs_.empty() && dabs_.back().t >= t) {
    for (const Index slot : dabs_.back().slots) {
      live_.remove(slot);
      vacant_.push_back(slot);
    }
    dabs_.pop_back();
  }
}

/// Computes one dab. It is empty when its middle is not near the surface, which does not happen when the
/// curve lies on it.
DabChart LiveDabs::chart(const CurvePoint& middle) {
  const double radius = radius_ * middle.width;
  const auto centre = CurveGround(*surface_, *picker_, base_)
                          .closest(middle.at.position, static_cast<float>(radius), middle.at);
  if (!centre) return {};
  if (!base_) return builder_.chart(centre->at, centre->normal, middle.tangent, {.radius = radius});
  const double wider = radius + dab_margin * base_->spacing();
  base_->prepare(std::array{
      BaseSurface::Ball{centre->at.position, wider + dab_margin * base_->spacing(), centre->at.corners[0]}});
  const DabChart nodes = of_base_->chart(centre->at, centre->normal, middle.tangent, {.radius = wider});
  return transferred_dab(*base_, *surface_, nodes, radius);
}

void LiveDabs::put(const CurvePoint& middle) {
  Dab& dab = dabs_.emplace_back(Dab{middle.t, {}});
  const DabChart chart = this->chart(middle);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const Index slot = vacant_slot();
    dab.slots.push_back(slot);
    live_.set(slot, chart.vertex[i],
              {.t = middle.t, .d = chart.v[i], .e1 = chart.e1[i], .curvature = 0, .stretch = 1},
              chart.normal[i]);
    along_.resize(std::max<std::size_t>(along_.size(), slot + 1));
    along_[slot] = chart.u[i];
  }
  settled_ += chart.size();
}

Index LiveDabs::vacant_slot() {
  if (vacant_.empty()) return static_cast<Index>(live_.nodes().size());
  const Index slot = vacant_.back();
  vacant_.pop_back();
  return slot;
}

}  // namespace burin
