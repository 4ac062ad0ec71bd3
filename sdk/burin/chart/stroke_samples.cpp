#include <burin/chart/closed_length.h>
#include <burin/chart/stroke_samples.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double samples_a_radius = 8, disc_over_width = 1.25;

/// Arc over chord, squared, of a circular arc whose normals have this cosine: (asin s / s)^2, s the sine of
/// half the angle. A polynomial within 4 %.
float squared_arc_over_chord(float cosine) {
  const float s2 = std::clamp((1 - cosine) / 2, 0.F, 1.F), s4 = s2 * s2;
  const float ratio = 1 + s2 / 6 + 0.075F * s4 + 0.329F * s4 * s4 * s2;
  return ratio * ratio;
}

/// By how much the disc around the sample at t must be wider to hold the extensions' corners.
double widening(const Extensions& extensions, double t, double length, double radius) {
  double widest = 1;
  for (const auto& [reach, way] : {std::pair(extensions.begin, t), std::pair(extensions.end, length - t)}) {
    const double corner = std::hypot(radius, reach);
    if (reach > 0 && way < corner) widest = std::max(widest, corner / radius);
  }
  return widest;
}

}  // namespace

Index StrokeSamples::update(const SurfaceCurve& curve, double radius, double finest,
                            const Extensions& extensions) {
  const std::vector<Sample> before = std::move(samples_);
  const bool was_closed = closed_;
  length_ = curve.length();
  closed_ = curve.closed;
  const double spacing = std::max(radius / samples_a_radius, finest);
  const double count = std::ceil(length_ / spacing);
  spacing_ = closed_ && count > 0 ? length_ / count : spacing;

  // Discs of neighbouring samples overlap, however narrow the stroke is.
  const auto least_disc = static_cast<float>(2 * spacing);
  samples_.clear();
  std::size_t segment = 0;
  const auto add = [&](double t) {
    while (segment + 1 < curve.segment_count() && curve.segment_end(segment) <= t) ++segment;
    const CurvePoint &a = curve.points[segment], &b = curve.points[curve.next(segment)];
    const double extent = curve.segment_end(segment) - a.t;
    const float s = extent > 0 ? static_cast<float>(std::min((t - a.t) / extent, 1.)) : 0;
    const Vec3f normal = (1 - s) * a.normal + s * b.normal;
    const float size = normal.norm();
    const float half_width = static_cast<float>(radius) * ((1 - s) * a.width + s * b.width);
    samples_.push_back({t, (1 - s) * a.at.position + s * b.at.position,
                        size > 0 ? Vec3f(normal / size) : a.normal, half_width,
                        std::max(half_width, least_disc) *
                            static_cast<float>(disc_over_width * widening(extensions, t, length_, radius))});
  };
  for (double i = 0; i < count; ++i) add(i * spacing_);
  if (!closed_ || samples_.empty()) add(length_);

  const auto differ = std::ranges::mismatch(before, samples_);
  return closed_ || was_closed ? 0 : static_cast<Index>(differ.in2 - samples_.begin());
}

Index StrokeSamples::at(double t) const {
  const Index last = size() - 1;
  if (closed_) {
    const double place = std::round(t / spacing_), count = static_cast<double>(size());
    return static_cast<Index>(place - count * std::floor(place / count)) % size();
  }
  if (t >= length_) return last;
  return std::min(static_cast<Index>(std::max(std::round(t / spacing_), 0.)), last);
}

double StrokeSamples::wrapped(double t) const { return closed_ ? wrapped_t(t, length_) : t; }

double StrokeSamples::unwrapped(double t, double near) const {
  return closed_ ? t_nearest_to(near, t, length_) : t;
}

double StrokeSamples::half_width(double t) const {
  const double place = closed_ ? t / spacing_ : std::clamp(t, 0., length_) / spacing_;
  const auto index = static_cast<Index>(std::max(place, 0.));
  const Sample& from = samples_[std::min(index, size() - 1)];
  const Sample& to = samples_[index + 1 < size() ? index + 1 : closed_ ? 0 : size() - 1];
  const double extent = closed_ ? spacing_ : to.t - from.t;
  const double s = extent > 0 ? std::clamp((t - from.t) / extent, 0., 1.) : 0;
  return static_cast<double>(from.half_width) + s * static_cast<double>(to.half_width - from.half_width);
}

bool StrokeSamples::disc_holds(Index sample, const Vec3f& position, const Vec3f& normal) const {
  const Sample& s = samples_[sample];
  return (position - s.position).squaredNorm() * squared_arc_over_chord(normal.dot(s.normal)) <=
         s.disc * s.disc;
}

}  // namespace burin
