// Filters against the tremor of the hand: a string whose end moves along a tractrix, and an exponential mean.
// Both integrate a straight, even motion between two samples exactly.
#include <burin/math/elementary.h>
#include <burin/stroke/pen_angles.h>
#include <burin/stroke/stabiliser.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The distance that the pen moves from `place` along the unit vector `way` until the string to the brush is
/// taut, at most `most`.
double slack(const Vec3d& brush, const Vec3d& place, const Vec3d& way, double length, double most) {
  const Vec3d string = place - brush;
  const double along = string.dot(way), missing = length * length - string.squaredNorm();
  if (missing <= 0 && along >= 0) return 0;
  return std::clamp(-along + std::sqrt(std::max(along * along + missing, 0.)), 0., most);
}

/// The position of the brush after the pen moved from `from` to `to`. Once the string is taut, the angle a
/// between it and the motion decreases as da/ds = -sin(a) / length, so tan(a / 2) decreases as
/// exp(-s / length).
Vec3d pulled(const Vec3d& brush, const Vec3d& from, const Vec3d& to, double length) {
  const double distance = (to - from).norm();
  if (distance == 0) return brush;
  const Vec3d way = (to - from) / distance;
  const double loose = slack(brush, from, way, length, distance);
  if (loose >= distance) return brush;
  const Vec3d string = from + loose * way - brush;
  const Vec3d across = string - string.dot(way) * way;
  const double side = across.norm();
  if (side == 0) return to - length * way;
  const double tan_half = side / (length + string.dot(way)) * math::exp(-(distance - loose) / length);
  const double cosine = (1 - tan_half * tan_half) / (1 + tan_half * tan_half);
  const double sine = 2 * tan_half / (1 + tan_half * tan_half);
  return to - length * (cosine * way + sine / side * across);
}

/// The exact response of the exponential filter to an input that moves linearly from x0 to x1:
/// y = x1 - past (x0 - y0) - ramp (x1 - x0), where y0 is the output before.
struct Response {
  Response(double seconds, double time_constant)
      : past(math::exp(-seconds / time_constant)),
        ramp(seconds > 0 ? -math::expm1(-seconds / time_constant) * time_constant / seconds : 1) {}

  template <class Value>
  Value operator()(const Value& before, const Value& from, const Value& to) const {
    return to - past * (from - before) - ramp * (to - from);
  }

  double past, ramp;
};

Pen lagging(const Response& response, const Pen& before, const Pen& from, const Pen& to) {
  const auto value = [&](float Pen::*field) {
    return static_cast<float>(response(double{before.*field}, double{from.*field}, double{to.*field}));
  };
  Pen pen = to;
  pen.pressure = std::clamp(value(&Pen::pressure), 0.F, 1.F);
  const double from_twist = twist_near(from.twist, before.twist);
  pen.twist = wrap_twist(response(double{before.twist}, from_twist, twist_near(to.twist, from_twist)));
  if (!same_tilt(before, to) || !same_tilt(from, to))
    set_upper_end(pen, response(upper_end(before), upper_end(from), upper_end(to)));
  return pen;
}

}  // namespace

Sample Stabiliser::add(const Sample& sample) {
  const Vec3d before = begun_ ? brush_.position : sample.position;
  if (!begun_) first_ = brush_ = pen_ = sample;
  begun_ = true;
  if (stabilising_.kind == Stabilising::Kind::exponential) {
    const Response response(sample.time - pen_.time, stabilising_.amount);
    brush_.position = response(brush_.position, pen_.position, sample.position);
    brush_.pen = lagging(response, brush_.pen, pen_.pen, sample.pen);
  } else {
    const bool pulls = stabilising_.kind == Stabilising::Kind::string;
    brush_.position =
        pulls ? pulled(before, pen_.position, sample.position, stabilising_.amount) : sample.position;
    brush_.pen = sample.pen;
  }
  brush_.time = sample.time;
  brush_path_ += (brush_.position - before).norm();
  pen_ = sample;
  return brush_;
}

std::optional<Sample> Stabiliser::finish() const {
  if (!begun_ || brush_.position == pen_.position) return std::nullopt;
  Sample last = pen_;
  if (brush_path_ > 0)
    last.time += (pen_.position - brush_.position).norm() * (brush_.time - first_.time) / brush_path_;
  return last;
}

std::vector<Sample> stabilised(std::span<const Sample> samples, const Stabilising& stabilising) {
  Stabiliser stabiliser(stabilising);
  std::vector<Sample> calm;
  calm.reserve(samples.size() + 1);
  for (const Sample& sample : samples) calm.push_back(stabiliser.add(sample));
  if (const auto last = stabiliser.finish()) calm.push_back(*last);
  return calm;
}

}  // namespace burin
