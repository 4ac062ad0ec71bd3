// Windows of straight lines that unfold from triangle to triangle [Chen and Han, Shortest paths on a
// polyhedron, 1990], nearest first, dropped where a vertex offers a shorter way [Xin and Wang, Improving Chen
// and Han's algorithm on the discrete geodesic problem, 2009]. Without Chen and Han's rule of one split an
// angle, which only saves time.
#include "support/polyhedral_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace burin::test {
namespace {

using Vec2d = Eigen::Vector2d;

constexpr double rounding = 1e-9;  ///< of an edge

double cross(const Vec2d& a, const Vec2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The lines from one point through part of an edge. Frame: the edge runs along x from vertex a at 0 to
/// vertex b, the triangle that the lines enter lies above, the point below.
struct Window {
  Index a, b;
  double begin, end;  ///< on the edge
  Vec2d source;
  double before;  ///< length of the way to the source
};

/// A window, or a vertex when there is none, in the order of the shortest way through it.
struct Event {
  double distance;
  Index vertex;
  std::optional<Window> window;
  bool operator>(const Event& other) const { return distance > other.distance; }
};

double distance_to(const Window& window, double x) {
  return window.before + std::hypot(window.source.x() - x, window.source.y());
}

class Unfolding {
 public:
  Unfolding(const Surface& surface, const Region& region);
  bool is_manifold() const { return manifold_; }
  void start(Index triangle, const SurfacePoint& from);
  std::vector<double> distances();

 private:
  double length(Index a, Index b) const { return (places_[a] - places_[b]).norm(); }
  void relax(Index vertex, double distance);
  void open(const Window& window);
  void open_from(const Vec3d& source, double before, Index a, Index b);
  void leave(Index vertex);
  void enter(const Window& window);

  const Region& region_;
  std::vector<Vec3d> places_;                        ///< [local vertex]
  std::map<std::pair<Index, Index>, Index> apexes_;  ///< [directed edge] third corner of its triangle
  std::vector<std::vector<std::pair<Index, Index>>> opposite_;  ///< [vertex] directed edges of its triangles
  std::vector<double> angles_;                                  ///< [vertex] sum; infinite on the boundary
  std::vector<double> distances_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
  bool manifold_ = true;
};

Unfolding::Unfolding(const Surface& surface, const Region& region)
    : region_(region),
      opposite_(region.vertices.size()),
      angles_(region.vertices.size(), 0),
      distances_(region.vertices.size(), std::numeric_limits<double>::infinity()) {
  for (const Index vertex : region.vertices) places_.push_back(surface.positions[vertex].cast<double>());
  for (const Triangle& corners : region.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
      manifold_ &= apexes_.try_emplace({a, b}, c).second;
      opposite_[c].emplace_back(a, b);
      const Vec3d to_a = places_[a] - places_[c], to_b = places_[b] - places_[c];
      angles_[c] += std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
    }
  }
  for (const auto& [edge, apex] : apexes_) {
    if (apexes_.contains({edge.second, edge.first})) continue;
    angles_[edge.first] = angles_[edge.second] = std::numeric_limits<double>::infinity();
  }
}

void Unfolding::start(Index triangle, const SurfacePoint& from) {
  const auto& [a, b, c] = region_.corners[triangle];
  // A little inside, so that no window is seen edge-on.
  const double u = (from.weights[1] + rounding) / (1 + 3 * rounding);
  const double v = (from.weights[2] + rounding) / (1 + 3 * rounding);
  const Vec3d source = (1 - u - v) * places_[a] + u * places_[b] + v * places_[c];
  for (const auto& [from_vertex, to_vertex] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    relax(from_vertex, (places_[from_vertex] - source).norm());
    open_from(source, 0, from_vertex, to_vertex);
  }
}

std::vector<double> Unfolding::distances() {
  while (!events_.empty()) {
    const Event event = events_.top();
    events_.pop();
    if (event.window) {
      enter(*event.window);
    } else if (event.distance == distances_[event.vertex]) {
      leave(event.vertex);
    }
  }
  return distances_;
}

void Unfolding::relax(Index vertex, double distance) {
  if (distance >= distances_[vertex]) return;
  distances_[vertex] = distance;
  events_.push({distance, vertex, std::nullopt});
}

/// Ways along edges, and straight on in all directions where shortest paths can bend.
void Unfolding::leave(Index vertex) {
  const bool bends = angles_[vertex] > 2 * std::numbers::pi + rounding;
  for (const auto& [a, b] : opposite_[vertex]) {
    relax(a, distances_[vertex] + length(vertex, a));
    relax(b, distances_[vertex] + length(vertex, b));
    if (bends) open_from(places_[vertex], distances_[vertex], a, b);
  }
}

/// The window onto the edge from a point of the triangle that has it as the directed edge (a, b).
void Unfolding::open_from(const Vec3d& source, double before, Index a, Index b) {
  const Vec3d along = (places_[a] - places_[b]).normalized(), to_source = source - places_[b];
  const double x = to_source.dot(along);
  open({b, a, 0, length(a, b), Vec2d(x, -(to_source - x * along).norm()), before});
}

void Unfolding::open(const Window& window) {
  const double edge = length(window.a, window.b), slack = rounding * edge;
  if (window.end - window.begin <= 0 || !apexes_.contains({window.a, window.b})) return;
  if (distance_to(window, window.end) > distances_[window.a] + window.end + slack) return;
  if (distance_to(window, window.begin) > distances_[window.b] + edge - window.begin + slack) return;
  const double nearest = distance_to(window, std::clamp(window.source.x(), window.begin, window.end));
  events_.push({nearest, no_index, window});
}

/// Crosses a triangle: to one or both of the other edges, and to the corner between them.
void Unfolding::enter(const Window& window) {
  const auto& [a, b, begin, end, source, before] = window;
  const Index apex = apexes_.at({a, b});
  const double ab = length(a, b), ac = length(a, apex), bc = length(b, apex);
  const double x = (ac * ac + ab * ab - bc * bc) / (2 * ab);
  const Vec2d c(x, std::sqrt(std::max(0., ac * ac - x * x))), to_b = Vec2d(ab, 0) - c;
  if (c.y() <= 0) return;
  const double split = source.x() + (c.x() - source.x()) * -source.y() / (c.y() - source.y());
  const double slack = rounding * ab;
  if (begin <= split + slack && split <= end + slack) relax(apex, before + (c - source).norm());

  /// Where the line from the source through x meets the line from `origin` along `direction`, in its lengths.
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
    open({a, apex, ac * hit(begin, zero, c), ac * last, seen_from(zero, c), before});
  }
  if (end > split) {
    const double first = begin > split ? hit(begin, c, to_b) : 0;
    open({apex, b, bc * first, bc * hit(end, c, to_b), seen_from(c, to_b), before});
  }
}

}  // namespace

std::optional<std::vector<double>> polyhedral_distances(const Surface& surface, const Region& region,
                                                        const SurfacePoint& from) {
  const Index triangle = local_index(region.triangles, from.triangle);
  Unfolding unfolding(surface, region);
  if (triangle == no_index || !unfolding.is_manifold()) return std::nullopt;
  unfolding.start(triangle, from);
  return unfolding.distances();
}

}  // namespace burin::test
