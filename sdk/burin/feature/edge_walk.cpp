// Shortest ways along the edges of lines (Dijkstra 1959). A way costs O(k log k) for the k vertices of lines
// within four times its length.
#include <burin/feature/edge_walk.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace burin {
namespace {

double distance(const Vec3f& a, const Vec3f& b) { return static_cast<double>((a - b).norm()); }

/// The ends of the edge that a point is on; one for a vertex.
std::vector<Index> ends_of(const SurfacePoint& point) {
  std::vector<Index> ends;
  for (std::size_t i = 0; i < 3; ++i)
    if (point.weights[i] > 0) ends.push_back(point.corners[i]);
  return ends;
}

bool are_on_one_edge(const std::vector<Index>& one, const std::vector<Index>& other) {
  std::set<Index> all(one.begin(), one.end());
  all.insert(other.begin(), other.end());
  return all.size() <= 2;
}

/// A run that grows along edges.
struct Walk {
  explicit Walk(const WalkLimits& of) : limits(of) {}

  void add_point(const SnappedPoint& point) {
    if (run.empty() || distance(run.back().at.position, point.at.position) >= limits.least_step)
      add(no_index, point);
  }

  /// Coming back to a vertex after a short way, the walk has been on a line that it does not follow.
  void add_vertex(Index vertex, const SnappedPoint& point) {
    double back = 0;
    for (std::size_t i = run.size(); i-- > 0 && back <= limits.longest_spur;) {
      back += distance(run[i].at.position, i + 1 < run.size() ? run[i + 1].at.position : point.at.position);
      if (vertices[i] != vertex) continue;
      run.resize(i + 1);
      vertices.resize(i + 1);
      return;
    }
    const bool is_crowded = run.size() > 1 && vertices.back() == no_index &&
                            distance(run.back().at.position, point.at.position) < limits.least_step;
    if (is_crowded) run.pop_back(), vertices.pop_back();
    add(vertex, point);
  }

  void add(Index vertex, const SnappedPoint& point) {
    run.push_back(point);
    vertices.push_back(vertex);
  }

  const WalkLimits& limits;
  SnappedRun run;
  std::vector<Index> vertices;  ///< [point] the vertex where it is, no_index within an edge
};

}  // namespace

EdgeWalk::EdgeWalk(const Surface& surface, std::span<const LineEdge> edges) : surface_(surface) {
  for (const LineEdge& edge : edges) {
    neighbours_[edge.vertices[0]].push_back(edge.vertices[1]);
    neighbours_[edge.vertices[1]].push_back(edge.vertices[0]);
  }
}

/// The vertices on the shortest way between two points on edges, if it is not too long.
std::vector<Index> EdgeWalk::way(const SurfacePoint& from, const SurfacePoint& to) const {
  constexpr double most_detour = 4;
  const std::vector<Index> starts = ends_of(from), goals = ends_of(to);
  if (are_on_one_edge(starts, goals)) return {};
  struct Reached {
    double way = std::numeric_limits<double>::infinity();
    Index before = no_index;
  };
  std::map<Index, Reached> reached;
  std::set<std::pair<double, Index>> open;
  const auto lead_on = [&](Index vertex, double way, Index before) {
    Reached& there = reached[vertex];
    if (!(way < there.way)) return;
    open.erase({there.way, vertex});
    there = {way, before};
    open.insert({way, vertex});
  };
  for (const Index start : starts)
    lead_on(start, distance(from.position, surface_.positions[start]), no_index);
  double best = most_detour * distance(from.position, to.position);
  Index last = no_index;
  while (!open.empty() && open.begin()->first < best) {
    const auto [length, vertex] = *open.begin();
    open.erase(open.begin());
    if (std::ranges::find(goals, vertex) != goals.end()) {
      const double whole = length + distance(surface_.positions[vertex], to.position);
      if (whole <= best) best = whole, last = vertex;
    }
    const auto found = neighbours_.find(vertex);
    if (found == neighbours_.end()) continue;
    for (const Index next : found->second)
      lead_on(next, length + distance(surface_.positions[vertex], surface_.positions[next]), vertex);
  }
  std::vector<Index> vertices;
  for (Index vertex = last; vertex != no_index; vertex = reached[vertex].before) vertices.push_back(vertex);
  std::ranges::reverse(vertices);
  return vertices;
}

SurfacePoint EdgeWalk::point_at(Index vertex) const {
  const Index triangle = surface_.incident[vertex].front();
  SurfacePoint point{triangle, surface_.triangles[triangle], {}, surface_.positions[vertex]};
  for (std::size_t i = 0; i < 3; ++i) point.weights[i] = point.corners[i] == vertex ? 1.F : 0.F;
  return point;
}

SnappedRun EdgeWalk::with_vertices(const SnappedRun& run, double period, const WalkLimits& limits) const {
  Walk walk(limits);
  for (std::size_t i = 0; i < run.size(); ++i) {
    walk.add_point(run[i]);
    if (i + 1 == run.size() && period == 0) break;
    SnappedPoint next = run[(i + 1) % run.size()];
    if (i + 1 == run.size()) next.stroke_t += period;
    const std::vector<Index> vertices = way(run[i].at, next.at);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const double share = (static_cast<double>(k) + 1) / (static_cast<double>(vertices.size()) + 1);
      walk.add_vertex(vertices[k],
                      {run[i].stroke_t + share * (next.stroke_t - run[i].stroke_t), point_at(vertices[k])});
    }
  }
  return std::move(walk.run);
}

}  // namespace burin
