// Computes the coordinates around joined corners and bends, in O(1) per node, from plane geometry. At the
// distance d beside a corner with the angle turn, a line of constant d continues on the outside along a
// circle around the corner, by the length d turn / 2 on either side of the bisector. On the inside it ends at
// the bisector, at d tan(turn / 2) before the corner.
#include <burin/chart/joins/joins.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr double sharpest_miter = 2 * std::numbers::pi / 3;

/// The length of grad t that smooth joins do not exceed on the inside.
constexpr double most_gradient = 2;

/// The share, 0 to 1, by which a smooth join takes t on the inside from that of the leg to one that goes on
/// across the bisector. Taken whole, t changes along the leg by q = span / (span - cut) and across it by
/// q tangent, where `cut` = |d| tangent is the way from the bisector to the corner. The share is the largest
/// with (1 + share (q - 1))^2 + (share q tangent)^2 <= most_gradient^2, so that t jumps at the bisector where
/// the corner is too sharp for its distance from other bends.
double inner_share(double tangent, double cut, double span) {
  if (cut >= span) return 0;
  const double q = span / (span - cut), along = q - 1, across = q * tangent;
  const double both = along * along + across * across;
  if (both == 0) return 1;
  const double root = std::sqrt(along * along + (most_gradient * most_gradient - 1) * both);
  return std::min((root - along) / both, 1.);
}

/// The stretch of a frame whose t is replaced by one that changes by `rate` times as much along e1.
float stretch_at_rate(const ChartFrame& frame, double rate) {
  const float stretch = frame.stretch / static_cast<float>(std::max(rate, 1e-3));
  return std::clamp(stretch, least_stretch, 1 / least_stretch);
}

}  // namespace

double bounded_half(double turn) { return std::min(std::abs(turn) / 2, 1.2); }

double miter_reach(double turn, double radius) {
  return std::abs(turn) < sharpest_miter ? radius * math::tan(std::abs(turn) / 2) : 0;
}

double smooth_reach(double turn, double radius) {
  const double half = std::abs(turn) / 2;
  return half <= bounded_half(turn) ? radius * math::sin(half) : 0;
}

bool on_own_side(const Corner& corner, bool first_leg, const ChartFrame& frame) {
  const double d = static_cast<double>(frame.d), tangent = math::tan(bounded_half(corner.turn));
  const double bisector = d * corner.turn > 0 ? -std::abs(d) * tangent : std::abs(d) * tangent;
  return way_beyond(corner, first_leg, frame.t) <= bisector;
}

ChartFrame smoothed(const Corner& corner, bool first_leg, const ChartFrame& frame, const Vec3f& normal) {
  const double way = way_beyond(corner, first_leg, frame.t), d = std::abs(static_cast<double>(frame.d));
  if (way <= -corner.span) return frame;
  const double half = std::abs(corner.turn) / 2;
  const bool inside = static_cast<double>(frame.d) * corner.turn > 0;
  ChartFrame joined = frame;
  double to_bisector = 0, all = 0, joins = 1;
  if (inside) {
    const double tangent = math::tan(bounded_half(corner.turn)), cut = d * tangent;
    joins = inner_share(tangent, cut, corner.span);
    to_bisector = std::max(-way - cut, 0.);
    all = std::max(corner.span - cut, 0.);
  } else {
    const double distance = way > 0 ? math::hypot(way, d) : d, phi = way > 0 ? math::atan2(way, d) : 0;
    to_bisector = distance * (half - phi) - std::min(way, 0.);
    all = corner.span + distance * half;
    joined.d = std::copysign(static_cast<float>(distance), frame.d);
    // Lines of constant distance turn around the corner.
    const double turned = std::copysign(phi, corner.turn) * (first_leg ? 1 : -1);
    joined.e1 = static_cast<float>(math::cos(turned)) * frame.e1 +
                static_cast<float>(math::sin(turned)) * normal.cross(frame.e1);
  }
  // At the start of the span t equals the leg's own t.
  const double leg = corner.span - (first_leg ? corner.first_past : corner.second_past);
  const double middle = first_leg ? corner.first - corner.first_past : corner.second + corner.second_past;
  const double share = all > 0 ? std::min(to_bisector / all, 1.) : 0;
  if (all > 0) joined.stretch = stretch_at_rate(frame, 1 + joins * (leg / all - 1));
  const double continuous = middle + (first_leg ? -leg : leg) * share;
  joined.t = frame.t + joins * (continuous - frame.t);
  return joined;
}

ChartFrame smoothed(const StrokeBends& bends, const Bend& bend, double span, const ChartFrame& frame) {
  const double way = frame.t - bend.middle, d = std::abs(static_cast<double>(frame.d));
  if (std::abs(way) >= span) return frame;
  const bool inside = static_cast<double>(frame.d) * bend.turn > 0;
  // The length of the line of constant d from the middle of the bend, with the sign of u.
  const auto along = [&](double u) {
    const double phi = std::abs(bends.turn(bend.middle, bend.middle + u));
    const double longer = inside ? -d * math::tan(bounded_half(2 * phi)) : d * phi;
    return std::copysign(std::max(std::abs(u) + longer, 0.), u);
  };
  const double all = std::abs(along(std::copysign(span, way)));
  const double tangent = math::tan(bounded_half(bend.turn));
  const double joins = inside ? inner_share(tangent, d * tangent, span) : 1;
  ChartFrame joined = frame;
  if (all > 0) {
    const double step = span / 64, rate = (along(way + step) - along(way - step)) / (2 * step);
    joined.stretch = stretch_at_rate(frame, 1 + joins * (span * rate / all - 1));
  }
  const double share = all > 0 ? std::clamp(along(way) / all, -1., 1.) : 0;
  joined.t += joins * (bend.middle + span * share - frame.t);
  return joined;
}

}  // namespace burin
