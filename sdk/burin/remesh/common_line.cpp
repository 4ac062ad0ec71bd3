// Whether two closed polygons run along the same line, and the order of their vertices along it. Each vertex
// of the second is found on the first, going on from the one before.
#include <burin/base/segment.h>
#include <burin/remesh/common_line.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// A closed polygon with its arc lengths.
struct Polygon {
  explicit Polygon(std::vector<Vec3d> vertices) : points(std::move(vertices)) {
    starts.push_back(0);
    for (std::size_t i = 0; i < points.size(); ++i)
      starts.push_back(starts.back() + (at(i + 1) - at(i)).norm());
  }

  const Vec3d& at(std::size_t i) const { return points[i % points.size()]; }
  double length() const { return starts.back(); }

  struct Foot {
    std::size_t side = 0;
    double along = 0;  // arc length
    double distance = std::numeric_limits<double>::max();
  };

  Foot foot_on(std::size_t side, const Vec3d& p) const {
    const Vec3d &from = at(side), way = at(side + 1) - from;
    const double share = share_on_segment(from, at(side + 1), p);
    return {side, starts[side] + share * way.norm(), (p - from - share * way).norm()};
  }

  Foot closest(const Vec3d& p) const {
    Foot best;
    for (std::size_t side = 0; side < points.size(); ++side)
      if (const Foot foot = foot_on(side, p); foot.distance < best.distance) best = foot;
    return best;
  }

  /// The closest among the sides from one on, as far as this many sides.
  Foot closest_from(std::size_t side, std::size_t sides, const Vec3d& p) const {
    Foot best;
    for (std::size_t k = 0; k < sides; ++k)
      if (const Foot foot = foot_on((side + k) % points.size(), p); foot.distance < best.distance)
        best = foot;
    return best;
  }

  std::vector<Vec3d> points;
  std::vector<double> starts;
};

/// The closest point to `p` on the sides that a line of this step can have come to, so that another strand
/// near by is not taken.
Polygon::Foot next_foot(const Polygon& line, std::size_t side, double step, double tolerance,
                        const Vec3d& p) {
  const std::size_t count = line.points.size();
  std::size_t sides = 1;
  for (double reach = 0; sides < count && reach < 2 * (step + tolerance); ++sides)
    reach += (line.at(side + sides) - line.at(side + sides - 1)).norm();
  // One side before, since the line may turn back by the tolerance.
  return line.closest_from((side + count - 1) % count, std::min(sides + 2, count), p);
}

/// The arc lengths on the first at which the vertices of the second are; nothing where it strays or turns
/// back.
std::optional<std::vector<double>> arc_lengths(const Polygon& first, const std::vector<Vec3d>& second,
                                               double tolerance) {
  if (!(first.length() > 0)) return {};
  Polygon::Foot foot = first.closest(second.front());
  std::vector<double> lengths;
  double along = foot.along;
  for (std::size_t j = 0; j < second.size(); ++j) {
    const double step = j == 0 ? 0 : (second[j] - second[j - 1]).norm();
    foot = next_foot(first, foot.side, step, tolerance, second[j]);
    const double ahead = std::remainder(foot.along - along, first.length());
    if (!(foot.distance <= tolerance) || ahead < -tolerance) return {};
    along += std::max(ahead, 0.);
    lengths.push_back(along);
  }
  const double whole = lengths.back() - lengths.front();
  if (whole > first.length() + tolerance || whole < 0.5 * first.length()) return {};
  return lengths;
}

std::vector<Vec3d> points_of(const PatchMesh& patch, const Loop& loop) {
  std::vector<Vec3d> points;
  for (const Index vertex : loop) points.push_back(patch.positions[vertex]);
  return points;
}

}  // namespace

std::optional<std::vector<OnLine>> along_common_line(const std::vector<Vec3d>& first,
                                                     const std::vector<Vec3d>& second, double tolerance) {
  const Polygon line(first);
  const std::optional<std::vector<double>> lengths = arc_lengths(line, second, tolerance);
  if (!lengths) return {};
  std::vector<OnLine> order;
  for (std::size_t j = 0; j < second.size(); ++j) order.push_back({(*lengths)[j], false, j});
  for (std::size_t i = 0; i < first.size(); ++i) {
    double at = line.starts[i];
    while (at < lengths->front()) at += line.length();
    order.push_back({at, true, i});
  }
  std::ranges::stable_sort(order, {}, &OnLine::along);
  return order;
}

std::vector<LinePair> pair_lines(const PatchMesh& first, const std::vector<Loop>& first_loops,
                                 const PatchMesh& second, const std::vector<Loop>& second_loops,
                                 double tolerance) {
  std::vector<LinePair> pairs;
  std::vector<std::vector<Vec3d>> first_points;
  for (const Loop& loop : first_loops) first_points.push_back(points_of(first, loop));
  std::vector<bool> taken(first_loops.size(), false);
  for (std::size_t j = 0; j < second_loops.size(); ++j) {
    const Loop turned(second_loops[j].rbegin(), second_loops[j].rend());
    const std::vector<Vec3d> points = points_of(second, turned);
    for (std::size_t i = 0; i < first_loops.size(); ++i) {
      if (taken[i]) continue;
      auto order = along_common_line(first_points[i], points, tolerance);
      if (!order) continue;
      pairs.push_back({i, j, turned, std::move(*order)});
      taken[i] = true;
      break;
    }
  }
  return pairs;
}

}  // namespace burin
