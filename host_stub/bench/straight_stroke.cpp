// Makes a straight stroke by walking over the surface in steps of at most a mean edge. Each step goes to the
// closest point of the surface and parallel transports the direction, which approximates a geodesic. It costs
// one closest-point query of the picker.
#include "bench/straight_stroke.h"

#include <burin/base/error.h>
#include <burin/surface/geometry/parallel_transport.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/radius_fit.h"

namespace burin {
namespace {

constexpr double sample_rate = 240;  // samples per second

Vec3f normal_at(const Surface& surface, const SurfacePoint& at) {
  Vec3f normal = Vec3f::Zero();
  for (std::size_t i = 0; i < 3; ++i) normal += at.weights[i] * surface.normals[at.corners[i]];
  return normal.normalized();
}

/// Traces an approximate geodesic over the surface step by step.
class Walker {
 public:
  Walker(const Surface& surface, const Picker& picker, const Vec3d& from, const Vec3d& towards)
      : surface_(surface), picker_(picker) {
    const auto start = picker.closest(from.cast<float>(), static_cast<float>(surface.scale));
    if (!start) throw Error("there is no surface near the beginning of the made stroke");
    at_ = start->position;
    normal_ = normal_at(surface, *start);
    direction_ = along((towards - from).cast<float>(), normal_);
    if (direction_.isZero(0)) throw Error("the made stroke sets out at right angles to the surface");
  }

  const Vec3f& at() const { return at_; }

  void step(double length) {
    const auto reach = static_cast<float>(length);
    const auto next = picker_.closest(at_ + reach * direction_, reach);
    if (!next) throw Error("the made stroke leaves the surface");
    const Vec3f normal = normal_at(surface_, *next);
    direction_ = along(transport(direction_, normal_, normal), normal);
    normal_ = normal;
    at_ = next->position;
  }

 private:
  /// The unit vector of a direction's tangential part; zero if there is none.
  static Vec3f along(const Vec3f& direction, const Vec3f& normal) {
    return (direction - normal.dot(direction) * normal).normalized();
  }

  const Surface& surface_;
  const Picker& picker_;
  Vec3f at_, normal_, direction_;
};

}  // namespace

Recording make_straight_stroke(const Surface& surface, const Picker& picker, const StraightStroke& stroke,
                               double radius) {
  const double spacing = stroke.length_radii * radius / static_cast<double>(stroke.samples - 1);
  const double steps = std::max(1.0, std::ceil(spacing / mean_edge_length(surface)));
  constexpr double most_steps = 1e7;
  if (const double all = steps * static_cast<double>(stroke.samples); !(all <= most_steps))
    throw Error(
        fmt::format("the made stroke is {:.3g} edges long; at most {:.0g} are walked", all, most_steps));
  Recording recording;
  RecordedStroke& recorded = recording.strokes.emplace_back();
  recorded.settings[&StrokeSettings::radius] = radius;
  recorded.fields.time = true;
  Walker walker(surface, picker, stroke.from, stroke.towards);
  for (std::size_t i = 0; i < stroke.samples; ++i) {
    if (i > 0)
      for (double step = 0; step < steps; ++step) walker.step(spacing / steps);
    recorded.samples.push_back({static_cast<double>(i) / sample_rate, walker.at().cast<double>(), {}});
  }
  return recording;
}

}  // namespace burin
