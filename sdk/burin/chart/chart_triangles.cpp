// Covers a chart with triangles of its nodes. Where vertices have several nodes, all combinations at a
// triangle's corners are tried, and those whose nodes lie nearest to each other in the chart are taken first.
// Costs about O(s^3) per triangle whose corners have s nodes each.
#include <burin/chart/chart_triangles.h>
#include <burin/chart/path/closed_length.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The nodes of a vertex, which are consecutive in the chart, from the first to before the last. For no_index
/// one no_index.
struct Nodes {
  std::size_t first, last;

  Nodes(const Chart& chart, Index vertex) : first(no_index), last(std::size_t{no_index} + 1) {
    if (vertex == no_index) return;
    const auto begin = chart.vertex.begin(), end = chart.vertex.end();
    const auto at = std::lower_bound(begin, end, vertex);
    first = last = static_cast<std::size_t>(at - begin);
    while (last < chart.vertex.size() && chart.vertex[last] == vertex) ++last;
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t node = first; node < last; ++node) visit(static_cast<Index>(node));
  }
};

/// The difference of t from node a to node b, the shorter way around on a closed stroke; 0 when either is
/// no_index.
double t_between(const Chart& chart, Index a, Index b) {
  return a == no_index || b == no_index ? 0 : t_beside(chart, chart.t[a], b) - chart.t[a];
}

/// Whether three nodes wind once around a closed stroke that is only a few edges long, so that no choice of
/// turns brings their arc lengths near each other.
bool wind_around(const Chart& chart, Index a, Index b, Index c) {
  if (!chart.closed || a == no_index || b == no_index || c == no_index) return false;
  return std::abs(t_between(chart, a, b) + t_between(chart, b, c) + t_between(chart, c, a)) >
         chart.length / 2;
}

/// Squared distance in the chart, object units.
double squared_distance(const Chart& chart, Index a, Index b) {
  if (a == no_index || b == no_index) return 0;
  const double stretch = static_cast<double>(chart.stretch[a] + chart.stretch[b]) / 2;
  const double along = stretch * t_between(chart, a, b);
  const double across = static_cast<double>(chart.d[b] - chart.d[a]);
  return along * along + across * across;
}

double longest_edge(const Surface& surface, const std::array<Index, 3>& corners) {
  float longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index a = corners[i], b = corners[(i + 1) % 3];
    if (a != no_index && b != no_index)
      longest = std::max(longest, (surface.positions[a] - surface.positions[b]).norm());
  }
  return static_cast<double>(longest);
}

/// Three nodes and how far apart they lie: the sum of the squared distances.
struct Triple {
  double spread;
  std::array<Index, 3> nodes;
  auto operator<=>(const Triple&) const = default;
};

bool share_a_node(const std::array<Index, 3>& a, const std::array<Index, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] == b[i] && a[i] != no_index) return true;
  }
  return false;
}

ChartTriangle beside_each_other(const Chart& chart, Index triangle, const std::array<Index, 3>& nodes) {
  ChartTriangle result{triangle, nodes, {}};
  const double near = chart.t[nodes[0]];
  for (std::size_t i = 0; i < 3; ++i) result.t[i] = t_beside(chart, near, nodes[i]);
  if (chart.closed && std::ranges::min(result.t) < 0) {
    for (double& t : result.t) t += chart.length;
  }
  return result;
}

/// What nodes_together() returns, into vectors that are used again from call to call.
void find_together(const Surface& surface, const Chart& chart, const std::array<Index, 3>& corners,
                   std::vector<Triple>& triples, std::vector<std::array<Index, 3>>& result) {
  constexpr double edges_apart = 2;
  const double reach = edges_apart * longest_edge(surface, corners), most = reach * reach;
  const Nodes first(chart, corners[0]), second(chart, corners[1]), third(chart, corners[2]);
  triples.clear();
  first.for_each([&](Index a) {
    second.for_each([&](Index b) {
      const double ab = squared_distance(chart, a, b);
      if (ab > most) return;
      third.for_each([&](Index c) {
        const double bc = squared_distance(chart, b, c), ca = squared_distance(chart, c, a);
        if (bc <= most && ca <= most && !wind_around(chart, a, b, c))
          triples.push_back({ab + bc + ca, {a, b, c}});
      });
    });
  });
  std::ranges::sort(triples);
  result.clear();
  for (const Triple& triple : triples) {
    const auto taken = [&](const std::array<Index, 3>& other) { return share_a_node(triple.nodes, other); };
    if (std::ranges::none_of(result, taken)) result.push_back(triple.nodes);
  }
  std::ranges::sort(result);
}

}  // namespace

double t_beside(const Chart& chart, double t, Index node) {
  return chart.closed ? t_nearest_to(t, chart.t[node], chart.length) : chart.t[node];
}

std::vector<std::array<Index, 3>> nodes_together(const Surface& surface, const Chart& chart,
                                                 const std::array<Index, 3>& corners) {
  std::vector<std::array<Index, 3>> result;
  std::vector<Triple> triples;
  find_together(surface, chart, corners, triples, result);
  return result;
}

std::vector<ChartTriangle> chart_triangles(const Surface& surface, const Chart& chart) {
  std::vector<Index> around;
  if (!surface.is_point_set()) {
    for (std::size_t node = 0; node < chart.size(); ++node) {
      if (chart.sheet[node] > 0) continue;
      const Index vertex = chart.vertex[node];
      for (const Index triangle : surface.incident[vertex]) {
        if (std::ranges::min(surface.triangles[triangle]) == vertex) around.push_back(triangle);
      }
    }
  }
  std::ranges::sort(around);
  std::vector<ChartTriangle> result;
  std::vector<Triple> triples;
  std::vector<std::array<Index, 3>> together;
  for (const Index triangle : around) {
    find_together(surface, chart, surface.triangles[triangle], triples, together);
    for (const auto& nodes : together) result.push_back(beside_each_other(chart, triangle, nodes));
  }
  return result;
}

}  // namespace burin
