// Joins two patches along a line that both of them end at. Both borders are polygons near that line; each
// vertex of one is found on the other, in order. Pairs of vertices that are close to each other become one,
// and the others split the edge of the other border that they lie on, so that both have the same vertices.
#include <burin/remesh/common_line.h>
#include <burin/remesh/join.h>

#include <algorithm>
#include <map>
#include <utility>

namespace burin {
namespace {

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
    return without_unused_vertices(both_);
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

  PatchMesh both_;  ///< all vertices, and the triangles of the first
  std::vector<Triangle> second_triangles_;
  Index offset_;
  std::vector<Index> same_;  ///< [vertex] which it became one with, or itself
  std::optional<Splitter> first_, second_;
};

}  // namespace

std::optional<PatchMesh> join(const PatchMesh& first, const PatchMesh& second, double tolerance) {
  const std::vector<Loop> loops = border_loops(first), others = border_loops(second);
  const std::vector<LinePair> pairs = pair_lines(first, loops, second, others, tolerance);
  if (pairs.size() != loops.size() || pairs.size() != others.size()) return {};
  Joint joint(first, second);
  for (const LinePair& pair : pairs) joint.join_loops(loops[pair.first], pair.turned, pair.order);
  return joint.result();
}

}  // namespace burin
