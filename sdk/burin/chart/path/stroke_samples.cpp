// Samples a stroke at even spacing and computes the discs that tell its visits apart. An update costs O(k log
// n) for k samples that differ and n points of the curve, and O(1) per sample that stays.
#include <burin/chart/path/curve_parts.h>
#include <burin/chart/path/stroke_samples.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace burin {
namespace {

/// The factor by which the disc around the sample at t must grow to hold the corners of the extensions.
double widening(const Extensions& extensions, double t, double length, double radius) {
  double widest = 1;
  for (const auto& [reach, way] : {std::pair(extensions.begin, t), std::pair(extensions.end, length - t)}) {
    const double corner = math::hypot(radius, reach);
    if (reach > 0 && way < corner) widest = std::max(widest, corner / radius);
  }
  return widest;
}

}  // namespace

Index StrokeSamples::update(const SurfaceCurve& curve, double radius, double finest,
                            const Extensions& extensions, std::size_t unchanged) {
  length_ = curve.length();
  closed_ = curve.closed;
  const double spacing = std::max(most_spacing(radius), finest);
  const double count = std::ceil(length_ / spacing);
  spacing_ = closed_ && count > 0 ? length_ / count : spacing;
  samples_per_unit_ = 1 / spacing_;

  // Samples before the last unchanged point stay, except the previous last one, which was at the stroke's
  // end.
  std::size_t kept = 0;
  if (unchanged > 0)
    while (kept + 1 < samples_.size() && samples_[kept].t < curve.points[unchanged - 1].t) ++kept;
  const std::vector<Sample> before(samples_.begin() + static_cast<std::ptrdiff_t>(kept), samples_.end());
  samples_.resize(kept);

  // Discs of neighbouring samples must overlap, however narrow the stroke is.
  const auto least_disc = static_cast<float>(2 * spacing);
  const auto add = [&](double t) {
    const CurvePoint at = point_at(curve, t);
    const float half_width = static_cast<float>(radius) * at.width;
    const float disc = std::max(half_width, least_disc) *
                       static_cast<float>(disc_over_width * widening(extensions, t, length_, radius));
    samples_.push_back({t, at.at.position, at.normal, half_width, disc});
  };
  for (auto i = static_cast<double>(kept); i < count; ++i) add(i * spacing_);
  if (!closed_ || samples_.empty()) add(length_);
  uniform_half_width_ = static_cast<double>(samples_[0].half_width);
  uniform_ = std::ranges::all_of(samples_,
                                 [this](const Sample& s) { return s.half_width == samples_[0].half_width; });

  find_turns(kept > 0 ? static_cast<Index>(kept - 1) : 0);
  const std::span<const Sample> now = std::span(samples_).subspan(kept);
  return static_cast<Index>(kept +
                            static_cast<std::size_t>(std::ranges::mismatch(before, now).in2 - now.begin()));
}

/// Updates may_turn_ from this sample on. Let u and w be the vectors from the previous sample and to the next
/// one. A point at y from the sample can be as near to both of them only if y . u <= -u^2 / 2 and y . w >=
/// w^2 / 2, and therefore |y| |w / |w| - u / |u|| >= (|u| + |w|) / 2.
void StrokeSamples::find_turns(Index from) {
  constexpr float rounding = 0.999F;
  may_turn_.resize(size());
  for (Index i = from; i < size(); ++i) {
    const bool end = !closed_ && (i == 0 || i + 1 == size());
    const Vec3f& at = samples_[i].position;
    const Vec3f u = at - samples_[(i == 0 ? size() : i) - 1].position,
                w = samples_[i + 1 == size() ? 0 : i + 1].position - at;
    const float before = u.norm(), after = w.norm();
    const float turn = (before * w - after * u).norm();
    may_turn_[i] = !end && samples_[i].disc * turn >= rounding * before * after * (before + after) / 2;
  }
}

Index StrokeSamples::at_of_closed(double t) const {
  if (!std::isfinite(t)) return 0;
  const double place = std::round(t / spacing_), count = static_cast<double>(size());
  return static_cast<Index>(place - count * std::floor(place / count)) % size();
}

double StrokeSamples::varying_half_width(double t) const {
  const double place = closed_ ? t / spacing_ : std::clamp(t, 0., length_) / spacing_;
  const auto index = static_cast<Index>(std::max(place, 0.));
  const Sample& from = samples_[std::min(index, size() - 1)];
  const Sample& to = samples_[index + 1 < size() ? index + 1 : closed_ ? 0 : size() - 1];
  const double extent = closed_ ? spacing_ : to.t - from.t;
  const double s = extent > 0 ? std::clamp((t - from.t) / extent, 0., 1.) : 0;
  return static_cast<double>(from.half_width) + s * static_cast<double>(to.half_width - from.half_width);
}

}  // namespace burin
