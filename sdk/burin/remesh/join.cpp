// Joins two patches along a line that both of them end at. Both borders are polygons near that line; each
// vertex of one is found on the other, in order. Pairs of vertices that are close to each other become one,
// and the others split the edge of the other border that they lie on, so that both have the same vertices.
#include <burin/base/error.h>
#include <burin/remesh/join.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace burin {
namespace {

using Loop = std::vector<Index>;
using Side = std::pair<Index, Index>;

/// The sides of triangles that no other triangle has in the other direction, with the triangle.
std::map<Side, std::size_t> border_sides(const std::vector<Triangle>& triangles) {
  std::map<Side, std::size_t> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Side side{triangles[t][i], triangles[t][(i + 1) % 3]};
      if (const auto other = sides.find({side.second, side.first}); other != sides.end())
        sides.erase(other);
      else
        sides.emplace(side, t);
    }
  return sides;
}

/// A closed polygon with its arc lengths.
struct Polygon {
  explicit Polygon(const PatchMesh& patch, const Loop& loop) {
    for (const Index vertex : loop) points.push_back(patch.positions[vertex]);
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
    const double squared = way.squaredNorm();
    const double share = squared > 0 ? std::clamp((p - from).dot(way) / squared, 0., 1.) : 0;
    return {side, starts[side] + share * std::sqrt(squared), (p - from - share * way).norm()};
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

/// A vertex of either border on the line that both run along.
struct OnLine {
  double along;  // arc length of the first border
  bool of_first;
  std::size_t number;  // in its loop
};

/// The vertices of both borders in the order along the line; nothing where the second strays from the first
/// by more than the tolerance, or turns back by more than it.
std::optional<std::vector<OnLine>> merged_order(const Polygon& first, const Polygon& second,
                                                double tolerance) {
  std::vector<OnLine> order;
  const Polygon::Foot start = first.closest(second.at(0));
  double along = start.along;
  std::size_t side = start.side;
  for (std::size_t j = 0; j < second.points.size(); ++j) {
    const double step = j == 0 ? 0 : (second.at(j) - second.at(j - 1)).norm();
    // Only as far as the border can have come, so that another strand of it near by is not taken.
    std::size_t sides = 1;
    for (double reach = 0; sides < first.points.size() && reach < 2 * step + 2 * tolerance; ++sides)
      reach += (first.at(side + sides) - first.at(side + sides - 1)).norm();
    const std::size_t from =
        (side + first.points.size() - std::min<std::size_t>(1, first.points.size() - 1)) %
        first.points.size();
    const Polygon::Foot foot =
        first.closest_from(from, std::min(sides + 2, first.points.size()), second.at(j));
    if (!(foot.distance <= tolerance)) return {};
    double ahead = std::remainder(foot.along - along, first.length());
    if (ahead < -tolerance) return {};
    ahead = std::max(ahead, 0.);
    along += ahead;
    side = foot.side;
    order.push_back({along, false, j});
  }
  if (along - start.along > first.length() + tolerance || along - start.along < 0.5 * first.length())
    return {};
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    double at = first.starts[i];
    while (at < start.along) at += first.length();
    order.push_back({at, true, i});
  }
  std::ranges::stable_sort(order, {}, &OnLine::along);
  return order;
}

/// Triangles whose border sides can be split.
class Splitter {
 public:
  explicit Splitter(std::vector<Triangle>& triangles)
      : triangles_(&triangles), sides_(border_sides(triangles)) {}

  /// Puts a vertex into a side of the border.
  void split(Side side, Index vertex) {
    const auto found = sides_.find(side);
    const std::size_t old = found->second;
    const Triangle triangle = (*triangles_)[old];
    const std::size_t i =
        static_cast<std::size_t>(std::ranges::find(triangle, side.first) - triangle.begin());
    const Index a = side.first, b = side.second, c = triangle[(i + 2) % 3];
    (*triangles_)[old] = {a, vertex, c};
    triangles_->push_back({vertex, b, c});
    sides_.erase(found);
    sides_[{a, vertex}] = old;
    sides_[{vertex, b}] = triangles_->size() - 1;
    if (const auto next = sides_.find({b, c}); next != sides_.end()) next->second = triangles_->size() - 1;
  }

 private:
  std::vector<Triangle>* triangles_;
  std::map<Side, std::size_t> sides_;
};

/// The two patches as one, their borders not yet joined; the second's vertices come after the first's.
class Joint {
 public:
  Joint(const PatchMesh& first, const PatchMesh& second)
      : both_(first), second_triangles_(second.triangles), offset_(first.vertex_count()) {
    both_.positions.insert(both_.positions.end(), second.positions.begin(), second.positions.end());
    both_.kept.insert(both_.kept.end(), second.kept.begin(), second.kept.end());
    for (Triangle& triangle : second_triangles_)
      for (Index& vertex : triangle) vertex += offset_;
    same_.resize(both_.positions.size());
    for (std::size_t v = 0; v < same_.size(); ++v) same_[v] = static_cast<Index>(v);
    first_.emplace(both_.triangles);
    second_.emplace(second_triangles_);
  }

  /// `order`: of the vertices of a loop of the first and one of the second, which is given turned round.
  void join_loops(const Loop& first, const Loop& turned, const std::vector<OnLine>& order) {
    const std::vector<bool> paired = pairs(first, turned, order);
    insert(order, paired, first, turned, true);
    insert(order, paired, first, turned, false);
  }

  PatchMesh result() {
    both_.triangles.insert(both_.triangles.end(), second_triangles_.begin(), second_triangles_.end());
    for (Triangle& triangle : both_.triangles)
      for (Index& vertex : triangle) vertex = same_[vertex];
    return without_unused();
  }

 private:
  Index vertex_of(const OnLine& at, const Loop& first, const Loop& turned) const {
    return at.of_first ? first[at.number] : turned[at.number] + offset_;
  }

  /// Makes one vertex of two neighbours in the order that are of different borders and closer to each other
  /// than to others by far. [i]: whether order[i] and its successor became one.
  std::vector<bool> pairs(const Loop& first, const Loop& turned, const std::vector<OnLine>& order) {
    constexpr double close = 0.4;
    const std::size_t count = order.size();
    std::vector<bool> paired(count, false);
    const auto point = [&](std::size_t i) -> const Vec3d& {
      return both_.positions[vertex_of(order[i % count], first, turned)];
    };
    const auto gap = [&](std::size_t i) { return (point(i + 1) - point(i)).norm(); };
    // Nearest pairs first.
    std::vector<std::pair<double, std::size_t>> gaps;
    for (std::size_t i = 0; i < count; ++i)
      if (order[i].of_first != order[(i + 1) % count].of_first) gaps.emplace_back(gap(i), i);
    std::ranges::sort(gaps);
    std::vector<bool> taken(count, false);
    for (const auto& [width, i] : gaps) {
      const std::size_t next = (i + 1) % count;
      if (taken[i] || taken[next]) continue;
      const double before = gap((i + count - 1) % count), after = gap(next);
      if (width > close * std::max(before, after)) continue;
      const Index a = vertex_of(order[i], first, turned), b = vertex_of(order[next], first, turned);
      const auto [kept, gone] = order[i].of_first ? std::pair(a, b) : std::pair(b, a);
      same_[gone] = kept;
      paired[i] = taken[i] = taken[next] = true;
    }
    return paired;
  }

  /// Splits the border of one of the patches at the vertices of the other one that have no partner.
  void insert(const std::vector<OnLine>& order, const std::vector<bool>& paired, const Loop& first,
              const Loop& turned, bool into_first) {
    const std::size_t count = order.size();
    const auto own = [&](std::size_t i) { return order[i].of_first == into_first; };
    const auto is_partner = [&](std::size_t i) { return paired[i] || paired[(i + count - 1) % count]; };
    std::size_t start = 0;
    while (!own(start)) ++start;
    Index last = vertex_of(order[start], first, turned);
    for (std::size_t k = 1; k <= count; ++k) {
      const std::size_t i = (start + k) % count;
      if (own(i)) {
        last = vertex_of(order[i], first, turned);
        continue;
      }
      if (is_partner(i)) continue;
      std::size_t ahead = i;
      while (!own(ahead)) ahead = (ahead + 1) % count;
      const Index next = vertex_of(order[ahead], first, turned), vertex = vertex_of(order[i], first, turned);
      // The first runs along the line, the second against it.
      if (into_first)
        first_->split({last, next}, vertex);
      else
        second_->split({next, last}, vertex);
      last = vertex;
    }
  }

  PatchMesh without_unused() const {
    PatchMesh joined;
    std::vector<Index> number(both_.positions.size(), no_index);
    std::vector<bool> used(both_.positions.size(), false);
    for (const Triangle& triangle : both_.triangles)
      for (const Index vertex : triangle) used[vertex] = true;
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      number[v] = joined.vertex_count();
      joined.positions.push_back(both_.positions[v]);
      joined.kept.push_back(both_.kept[v]);
    }
    for (const auto& [a, b, c] : both_.triangles)
      joined.triangles.push_back({number[a], number[b], number[c]});
    return joined;
  }

  PatchMesh both_;  ///< all vertices, and the triangles of the first
  std::vector<Triangle> second_triangles_;
  Index offset_;
  std::vector<Index> same_;  ///< [vertex] which it became one with, or itself
  std::optional<Splitter> first_, second_;
};

}  // namespace

std::vector<Loop> border_loops(const PatchMesh& patch) {
  std::map<Index, Index> next;
  for (const auto& [side, triangle] : border_sides(patch.triangles)) {
    if (patch.is_fixed(side.first) || patch.is_fixed(side.second)) continue;
    if (!next.emplace(side.first, side.second).second) throw Error("the border of a patch touches itself");
  }
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop& loop = loops.emplace_back();
    Index vertex = next.begin()->first;
    for (auto at = next.begin(); at != next.end(); at = next.find(vertex)) {
      loop.push_back(vertex);
      vertex = at->second;
      next.erase(at);
    }
  }
  return loops;
}

std::optional<PatchMesh> join(const PatchMesh& first, const PatchMesh& second, double tolerance) {
  std::vector<Loop> loops = border_loops(first);
  std::vector<Loop> others = border_loops(second);
  if (loops.size() != others.size()) return {};
  Joint joint(first, second);
  for (Loop& other : others) {
    std::ranges::reverse(other);
    const Polygon polygon(second, other);
    bool joined = false;
    for (std::size_t i = 0; i < loops.size() && !joined; ++i) {
      const std::optional<std::vector<OnLine>> order =
          merged_order(Polygon(first, loops[i]), polygon, tolerance);
      if (!order) continue;
      joint.join_loops(loops[i], other, *order);
      loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(i));
      joined = true;
    }
    if (!joined) return {};
  }
  return joint.result();
}

}  // namespace burin
