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

/// The signed distance from the corner to a node along the node's leg: negative on the leg, positive beyond.
double way_beyond(const Corner& corner, bool first_leg, double t) {
  return first_leg ? t - corner.first : corner.second - t;
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
  double to_bisector = 0, all = 0;
  if (inside) {
    const double cut = d * math::tan(bounded_half(corner.turn));
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
  const double leg =
      first_leg ? corner.middle - (corner.first - corner.span) : corner.second + corner.span - corner.middle;
  const double share = all > 0 ? std::min(to_bisector / all, 1.) : 0;
  joined.t = corner.middle + (first_leg ? -leg : leg) * share;
  return joined;
}

double smoothed_t(const StrokeBends& bends, const Bend& bend, double span, double t, double d) {
  const double way = t - bend.middle;
  if (std::abs(way) >= span) return t;
  const bool inside = d * bend.turn > 0;
  const auto along = [&](double u) {
    const double phi = std::abs(bends.turn(bend.middle, bend.middle + u));
    const double longer = inside ? -std::abs(d) * math::tan(bounded_half(2 * phi)) : std::abs(d) * phi;
    return std::max(std::abs(u) + longer, 0.);
  };
  const double all = along(std::copysign(span, way));
  return all > 0 ? bend.middle + std::copysign(span * std::min(along(way) / all, 1.), way) : bend.middle;
}

}  // namespace burin
