// Converts the tilts of a pen to a direction and back, and interpolates pens.
#include <burin/math/elementary.h>
#include <burin/stroke/pen_angles.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Whether the tilts differ by less than 0.1 radians. Interpolating such tilts as numbers gives the same
/// direction to second order and is faster, which matters since every node interpolates a pen.
bool close_tilts(const Pen& a, const Pen& b) {
  constexpr float close = 0.1F;
  return std::abs(a.tilt_x - b.tilt_x) < close && std::abs(a.tilt_y - b.tilt_y) < close;
}

}  // namespace

Vec3d upper_end(const Pen& pen) {
  constexpr double flat = std::numbers::pi / 2;
  const double x = std::clamp(double{pen.tilt_x}, -flat, flat),
               y = std::clamp(double{pen.tilt_y}, -flat, flat);
  const double cos_x = math::cos(x), cos_y = math::cos(y);
  return Vec3d(math::sin(x) * cos_y, cos_x * math::sin(y), cos_x * cos_y).stableNormalized();
}

void set_upper_end(Pen& pen, const Vec3d& direction) {
  constexpr double least_slope = 0.05 / 360 * full_turn;
  const double up = std::max(direction.z(), least_slope * direction.head<2>().norm());
  pen.tilt_x = static_cast<float>(math::atan2(direction.x(), up));
  pen.tilt_y = static_cast<float>(math::atan2(direction.y(), up));
}

bool same_tilt(const Pen& a, const Pen& b) { return a.tilt_x == b.tilt_x && a.tilt_y == b.tilt_y; }

double twist_near(double twist, double near) {
  const double off = twist - near;
  return std::abs(off) <= full_turn / 2 ? twist : twist - full_turn * std::round(off / full_turn);
}

float wrap_twist(double twist) {
  const auto within = static_cast<float>(
      twist >= 0 && twist < full_turn ? twist : twist - full_turn * std::floor(twist / full_turn));
  return double{within} < full_turn ? within : 0;
}

Pen pen_between(const Pen& a, const Pen& b, float share) {
  const auto mix = [share](float x, float y) { return x + share * (y - x); };
  Pen pen{.pressure = mix(a.pressure, b.pressure),
          .tilt_x = mix(a.tilt_x, b.tilt_x),
          .tilt_y = mix(a.tilt_y, b.tilt_y),
          .twist = wrap_twist(a.twist + double{share} * (twist_near(b.twist, a.twist) - a.twist))};
  if (!close_tilts(a, b)) set_upper_end(pen, upper_end(a) + double{share} * (upper_end(b) - upper_end(a)));
  return pen;
}

}  // namespace burin
