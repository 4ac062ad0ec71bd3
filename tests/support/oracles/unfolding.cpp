// Propagates windows of straight lines that unfold from triangle to triangle [Chen and Han, Shortest paths on
// a polyhedron, 1990], nearest first, and drops those for which a vertex offers a shorter path [Xin and Wang,
// Improving Chen and Han's algorithm on the discrete geodesic problem, 2009]. Chen and Han's rule of one
// split per angle, which only saves time, is not implemented.
#include "unfolding.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace burin::test {
namespace {

constexpr double rounding = 1e-9;  ///< tolerance as a share of an edge

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

Unfolding::Unfolding(const Surface& surface, const Region& region)
    : region_(region),
      twins_(3 * region.corners.size(), no_index),
      opposite_(region.vertices.size()),
      angles_(region.vertices.size(), 0),
      targets_in_(region.corners.size()) {
  for (const Index vertex : region.vertices) places_.push_back(surface.positions[vertex].cast<double>());
  std::map<std::pair<Index, Index>, Index> sides;
  for (Index side = 0; side < twins_.size(); ++side) {
    const Index a = begin_of(side), b = end_of(side), c = end_of(next_side(side));
    manifold_ &= sides.try_emplace({a, b}, side).second;
    opposite_[c].push_back(side);
    const Vec3d to_a = places_[a] - places_[c], to_b = places_[b] - places_[c];
    angles_[c] += std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
  }
  for (const auto& [ends, side] : sides) {
    const auto twin = sides.find({ends.second, ends.first});
    if (twin == sides.end()) {
      angles_[ends.first] = angles_[ends.second] = unreached;
    } else {
      twins_[side] = twin->second;
    }
  }
}

void Unfolding::clear(double most, double beyond_nearest) {
  distances_.assign(places_.size(), unreached);
  reached_.assign(targets_.size(), unreached);
  nearest_ = unreached;
  most_ = most;
  beyond_nearest_ = beyond_nearest;
  events_ = {};
}

void Unfolding::aim_at(std::span<const SurfacePoint> points) {
  for (const SurfacePoint& point : points) {
    const Index triangle = local_index(region_.triangles, point.triangle);
    Target target{{}, Vec3d::Zero()};
    for (std::size_t i = 0; triangle != no_index && i < 3; ++i) {
      target.weights[i] = static_cast<double>(point.weights[i]);
      target.place += target.weights[i] * places_[region_.corners[triangle][i]];
    }
    if (triangle != no_index) targets_in_[triangle].push_back(static_cast<Index>(targets_.size()));
    targets_.push_back(target);
  }
}

void Unfolding::find_from(Index triangle, const SurfacePoint& from) {
  clear(unreached, unreached);
  const auto& [a, b, c] = region_.corners[triangle];
  // The point is moved slightly inside, so that no window is seen edge-on.
  const double u = (from.weights[1] + rounding) / (1 + 3 * rounding);
  const double v = (from.weights[2] + rounding) / (1 + 3 * rounding);
  const Vec3d source = (1 - u - v) * places_[a] + u * places_[b] + v * places_[c];
  reach_inside(triangle, source, 0);
  for (Index side = 3 * triangle; side < 3 * triangle + 3; ++side) {
    relax(begin_of(side), (places_[begin_of(side)] - source).norm());
    open_from(source, 0, side);
  }
  run();
}

void Unfolding::find_from(Index vertex, double most, double beyond_nearest) {
  clear(most, beyond_nearest);
  distances_[vertex] = 0;
  leave(vertex, true);
  run();
}

void Unfolding::run() {
  while (!events_.empty()) {
    const Event event = events_.top();
    events_.pop();
    if (event.distance > limit()) return;
    if (event.window) {
      enter(*event.window);
    } else if (event.distance == distances_[event.vertex]) {
      leave(event.vertex, angles_[event.vertex] > 2 * std::numbers::pi + rounding);
    }
  }
}

double Unfolding::Window::distance_to(double x) const {
  const double along = source.x() - x;
  return before + std::sqrt(along * along + source.y() * source.y());
}

void Unfolding::relax(Index vertex, double distance) {
  if (distance >= distances_[vertex]) return;
  distances_[vertex] = distance;
  events_.push({distance, vertex, std::nullopt});
}

void Unfolding::reach(Index target, double distance) {
  reached_[target] = std::min(reached_[target], distance);
  nearest_ = std::min(nearest_, distance);
}

/// Opens windows and reaches targets from a point of the triangle.
void Unfolding::reach_inside(Index triangle, const Vec3d& source, double before) {
  for (const Index target : targets_in_[triangle])
    reach(target, before + (targets_[target].place - source).norm());
}

/// Continues from a vertex along its edges and, if shortest paths can bend there, in all directions.
void Unfolding::leave(Index vertex, bool bends) {
  for (const Index side : opposite_[vertex]) {
    relax(begin_of(side), distances_[vertex] + length(vertex, begin_of(side)));
    relax(end_of(side), distances_[vertex] + length(vertex, end_of(side)));
    reach_inside(side / 3, places_[vertex], distances_[vertex]);
    if (bends) open_from(places_[vertex], distances_[vertex], side);
  }
}

/// Opens the window from a point of a triangle over one of its sides.
void Unfolding::open_from(const Vec3d& source, double before, Index side) {
  const Vec3d &a = places_[begin_of(side)], &b = places_[end_of(side)];
  const Vec3d along = (a - b).normalized(), to_source = source - b;
  const double x = to_source.dot(along);
  open({twins_[side], 0, (a - b).norm(), Vec2d(x, -(to_source - x * along).norm()), before});
}

void Unfolding::open(const Window& window) {
  if (window.end - window.begin <= 0 || window.side == no_index) return;
  const double edge = length(window.side), slack = rounding * edge;
  if (window.distance_to(window.end) > distances_[begin_of(window.side)] + window.end + slack) return;
  if (window.distance_to(window.begin) > distances_[end_of(window.side)] + edge - window.begin + slack)
    return;
  const double nearest = window.distance_to(std::clamp(window.source.x(), window.begin, window.end));
  if (nearest <= limit()) events_.push({nearest, no_index, window});
}

/// Propagates a window across a triangle: to one or both of the other sides, the corner between them, and
/// targets.
void Unfolding::enter(const Window& window) {
  const auto& [side, begin, end, source, before] = window;
  const Index to_apex = next_side(side), from_apex = next_side(to_apex), apex = end_of(to_apex);
  const double ab = length(side), ac = length(from_apex), bc = length(to_apex);
  const double x = (ac * ac + ab * ab - bc * bc) / (2 * ab);
  const Vec2d c(x, std::sqrt(std::max(0., ac * ac - x * x))), to_b = Vec2d(ab, 0) - c;
  if (c.y() <= 0) return;
  const double split = source.x() + (c.x() - source.x()) * -source.y() / (c.y() - source.y());
  const double slack = rounding * ab;
  if (begin <= split + slack && split <= end + slack) relax(apex, before + (c - source).norm());
  reach_through(window, c);

  /// The parameter, in multiples of `direction`, at which the line from the source through x meets the line
  /// from `origin` along `direction`.
  const auto hit = [&](double through, const Vec2d& origin, const Vec2d& direction) {
    const Vec2d line(through - source.x(), -source.y());
    return std::clamp(cross(source - origin, line) / cross(direction, line), 0., 1.);
  };
  const auto seen_from = [&](const Vec2d& origin, const Vec2d& direction) {
    const Vec2d along = direction.normalized(), from = source - origin;
    return Vec2d(from.dot(along), cross(along, from));
  };
  const Vec2d zero(0, 0);
  if (begin < split) {
    const double last = end < split ? hit(end, zero, c) : 1;
    open({twins_[from_apex], ac * hit(begin, zero, c), ac * last, seen_from(zero, c), before});
  }
  if (end > split) {
    const double first = begin > split ? hit(begin, c, to_b) : 0;
    open({twins_[to_apex], bc * first, bc * hit(end, c, to_b), seen_from(c, to_b), before});
  }
}

/// Updates the distances of the triangle's targets that the window's lines meet.
void Unfolding::reach_through(const Window& window, const Vec2d& apex) {
  const Index side = window.side;
  const double ab = length(side), slack = rounding * ab;
  for (const Index target : targets_in_[side / 3]) {
    const auto& weights = targets_[target].weights;
    const Vec2d place =
        weights[next_side(side) % 3] * Vec2d(ab, 0) + weights[next_side(next_side(side)) % 3] * apex;
    const double rise = place.y() - window.source.y();
    const double through =
        rise > 0 ? window.source.x() + (place.x() - window.source.x()) * -window.source.y() / rise
                 : place.x();
    if (window.begin <= through + slack && through <= window.end + slack)
      reach(target, window.before + (place - window.source).norm());
  }
}

}  // namespace burin::test
