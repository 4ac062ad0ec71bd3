// Levels by clustering. Each vertex that no cluster has reached yet, in the order along the space-filling
// curve, becomes the middle of a new one, which takes all vertices within its reach along edges that are not
// nearer to another middle: a Poisson disc sampling with its Voronoi cells, by bounded runs of Dijkstra's
// algorithm. Ranges of consecutive vertices are clustered side by side; no cluster crosses their borders.
#include <burin/base/counting_sort.h>
#include <burin/base/sort_unique.h>
#include <burin/surface/collect_rows.h>
#include <burin/surface/surface_levels.h>
#include <burin/surface/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

namespace burin {
namespace {

constexpr Index vertices_a_range = 32768, rows_a_block = 4096, clusters_a_block = 256;

/// Levels with fewer clusters are of no use to any stroke.
constexpr Index fewest_clusters = 64;

/// Middles farther apart than this share of a spacing leave about one cluster for the area of a spacing.
constexpr double reach_over_spacing = 0.65;

constexpr double first_spacing_over_edge = 1.7, spacing_over_spacing = 2;

/// Vertices joined by edges.
struct Graph {
  std::span<const Vec3f> positions;
  const Csr& neighbours;
};

/// The clusters of one range of vertices.
class RangeClusters {
 public:
  /// Numbers clusters from 0 in `cluster_of`, whose elements of the range, as those of `distance`, are its
  /// own to write.
  RangeClusters(const Graph& graph, float reach, std::span<Index> cluster_of, std::span<float> distance)
      : graph_(graph), reach_(reach), cluster_of_(cluster_of), distance_(distance) {}

  /// Returns the middles.
  std::vector<Index> make(Index begin, Index end) {
    std::fill(distance_.begin() + begin, distance_.begin() + end, std::numeric_limits<float>::infinity());
    std::vector<Index> middles;
    for (Index vertex = begin; vertex < end; ++vertex) {
      if (distance_[vertex] <= reach_) continue;
      grow(vertex, static_cast<Index>(middles.size()), begin, end);
      middles.push_back(vertex);
    }
    return middles;
  }

 private:
  struct Entry {
    float distance;
    Index vertex;
    auto operator<=>(const Entry&) const = default;
  };

  void grow(Index middle, Index cluster, Index begin, Index end) {
    put(middle, 0, cluster);
    while (!queue_.empty()) {
      std::ranges::pop_heap(queue_, std::greater<>());
      const Entry next = queue_.back();
      queue_.pop_back();
      if (next.distance > distance_[next.vertex]) continue;
      for (const Index neighbour : graph_.neighbours[next.vertex]) {
        if (neighbour < begin || neighbour >= end) continue;
        const float edge = (graph_.positions[neighbour] - graph_.positions[next.vertex]).norm();
        const float through = next.distance + edge;
        if (through <= reach_ && through < distance_[neighbour]) put(neighbour, through, cluster);
      }
    }
  }

  void put(Index vertex, float distance, Index cluster) {
    distance_[vertex] = distance;
    cluster_of_[vertex] = cluster;
    queue_.push_back({distance, vertex});
    std::ranges::push_heap(queue_, std::greater<>());
  }

  const Graph& graph_;
  float reach_;
  std::span<Index> cluster_of_;
  std::span<float> distance_;
  std::vector<Entry> queue_;
};

/// Sets level.cluster_of; returns the middles, [cluster].
std::vector<Index> make_clusters(const Graph& graph, double reach, SurfaceLevel& level) {
  const auto vertices = static_cast<Index>(graph.positions.size());
  level.cluster_of.resize(vertices);
  UnsetVector<float> distance(vertices);
  std::vector<std::vector<Index>> middles(vertices / vertices_a_range + 1);  // [range]
  parallel_blocks(vertices, vertices_a_range, [&](std::size_t begin, std::size_t end) {
    middles[begin / vertices_a_range] =
        RangeClusters(graph, static_cast<float>(reach), level.cluster_of, distance)
            .make(static_cast<Index>(begin), static_cast<Index>(end));
  });
  std::vector<Index> all, first{0};
  for (const std::vector<Index>& of_range : middles) {
    all.insert(all.end(), of_range.begin(), of_range.end());
    first.push_back(static_cast<Index>(all.size()));
  }
  parallel_blocks(vertices, vertices_a_range, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) level.cluster_of[i] += first[begin / vertices_a_range];
  });
  return all;
}

void connect(const Graph& graph, Index clusters, SurfaceLevel& level) {
  level.members.items.resize(level.cluster_of.size());
  level.members.offsets = counting_sort(
      level.cluster_of.size(), clusters, [&](std::size_t i, const auto& emit) { emit(level.cluster_of[i]); },
      [&](std::size_t i, std::size_t position) { level.members.items[position] = static_cast<Index>(i); });
  level.neighbours = collect_rows(clusters, rows_a_block, [&](Index cluster, UnsetVector<Index>& out) {
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    for (const Index member : level.members[cluster])
      for (const Index neighbour : graph.neighbours[member])
        if (level.cluster_of[neighbour] != cluster) out.push_back(level.cluster_of[neighbour]);
    std::sort(out.begin() + first, out.end());
    out.erase(std::unique(out.begin() + first, out.end()), out.end());
  });
}

/// The share that a point of a point set has of the disc of its neighbours and itself. Where n points lie
/// evenly in a disc of radius R, the mean square of their distances from the middle is R^2 / 2.
double area_of_point(const Surface& surface, Index point) {
  double squares = 0, count = 1;
  for (const Index neighbour : surface.neighbours[point]) {
    squares += static_cast<double>((surface.positions[neighbour] - surface.positions[point]).squaredNorm());
    ++count;
  }
  return 2 * std::numbers::pi * squares / (count * count);
}

/// A vertex has a third of each triangle around it.
double area_of_vertex(const Surface& surface, Index vertex) {
  double doubled = 0;
  for (const Index index : surface.incident[vertex]) {
    const auto& [a, b, c] = surface.triangles[index];
    const Vec3f& at = surface.positions[a];
    doubled += static_cast<double>((surface.positions[b] - at).cross(surface.positions[c] - at).norm());
  }
  return doubled / 6;
}

/// Length of the edges of a lattice of equilateral triangles that has this vertex's share of the area for
/// each. 0: it has no neighbours.
double edge_at(const Surface& surface, Index vertex) {
  const double area =
      surface.is_point_set() ? area_of_point(surface, vertex) : area_of_vertex(surface, vertex);
  return std::sqrt(2 / std::sqrt(3.) * area);
}

/// Length of the edges where the surface is fine: a tenth of its vertices have shorter ones. By that, and not
/// by all vertices and the whole area, levels are fine enough wherever a brush may draw. Vertices without
/// edges do not count; 0: there are no others.
double fine_edge(const Surface& surface) {
  constexpr Index most_vertices = 65536;
  std::vector<double> lengths;
  for (Index vertex = 0; vertex < surface.vertex_count();
       vertex += surface.vertex_count() / most_vertices + 1)
    if (const double length = edge_at(surface, vertex); length > 0) lengths.push_back(length);
  if (lengths.empty()) return 0;
  const auto tenth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 10);
  std::nth_element(lengths.begin(), tenth, lengths.end());
  return *tenth;
}

/// A vertex has a third of each triangle around it.
ClusterMean mean_of_vertex(const Surface& surface, Index vertex) {
  const Vec3f& at = surface.positions[vertex];
  if (surface.is_point_set())
    return {at, static_cast<float>(area_of_point(surface, vertex)) * surface.normals[vertex]};
  Vec3d doubled = Vec3d::Zero();
  for (const Index index : surface.incident[vertex]) {
    const Triangle& triangle = surface.triangles[index];
    const std::size_t corner = corner_of(triangle, vertex);
    doubled += (surface.positions[triangle[(corner + 1) % 3]] - at)
                   .cross(surface.positions[triangle[(corner + 2) % 3]] - at)
                   .cast<double>();
  }
  return {at, (doubled / 6).cast<float>()};
}

/// These, ascending, without repetition, and those that neighbour them.
std::vector<Index> with_neighbours(const Csr& neighbours, std::span<const Index> rows) {
  std::vector<Index> all(rows.begin(), rows.end());
  for (const Index row : rows) all.insert(all.end(), neighbours[row].begin(), neighbours[row].end());
  sort_unique(all);
  return all;
}

}  // namespace

SurfaceLevels::SurfaceLevels(const Surface& surface) : surface_(&surface) {
  edge_ = fine_edge(surface);
  if (!(edge_ > 0)) return;
  std::vector<Vec3f> middles;  // of the last level
  for (double spacing = first_spacing_over_edge * edge_;; spacing *= spacing_over_spacing) {
    const Graph graph = coarser_.empty() ? Graph{surface.positions, surface.neighbours}
                                         : Graph{middles, coarser_.back().neighbours};
    SurfaceLevel level;
    const std::vector<Index> vertices = make_clusters(graph, reach_over_spacing * spacing, level);
    const auto clusters = static_cast<Index>(vertices.size());
    if (clusters < fewest_clusters || clusters == graph.positions.size()) return;
    connect(graph, clusters, level);
    level.spacing = spacing;
    std::vector<Vec3f> positions;
    for (const Index vertex : vertices) positions.push_back(graph.positions[vertex]);
    middles = std::move(positions);
    coarser_.push_back(std::move(level));
    if (coarser_.size() < first_with_means) continue;
    std::vector<Index> all(clusters);
    std::iota(all.begin(), all.end(), Index{0});
    coarser_.back().means.resize(clusters);
    update_means(coarser_.size(), all);
  }
}

ClusterMean SurfaceLevels::mean(std::size_t level, Index cluster) const {
  if (level == 0) return mean_of_vertex(*surface_, cluster);
  return level < first_with_means ? mean_of_members(level, cluster) : coarser_[level - 1].means[cluster];
}

ClusterMean SurfaceLevels::mean_of_members(std::size_t level, Index cluster) const {
  Vec3d weighted = Vec3d::Zero(), plain = Vec3d::Zero(), area = Vec3d::Zero();
  double weights = 0;
  for (const Index member : members(level, cluster)) {
    const ClusterMean of_member = mean(level - 1, member);
    const Vec3d position = of_member.position.cast<double>();
    const auto weight = static_cast<double>(of_member.area.norm());
    weighted += weight * position;
    weights += weight;
    plain += position;
    area += of_member.area.cast<double>();
  }
  const auto count = static_cast<double>(members(level, cluster).size());
  const Vec3d position = weights > 0 ? Vec3d(weighted / weights) : Vec3d(plain / count);
  return {position.cast<float>(), area.cast<float>()};
}

void SurfaceLevels::update_means(std::size_t level, std::span<const Index> clusters) {
  std::vector<ClusterMean>& means = coarser_[level - 1].means;
  parallel_blocks(clusters.size(), clusters_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) means[clusters[i]] = mean_of_members(level, clusters[i]);
  });
}

/// Areas of triangles beside a vertex belong to its neighbours too.
void SurfaceLevels::moved(std::span<const Index> vertices) {
  std::size_t level = first_with_means;
  if (level >= size()) return;
  std::vector<Index> clusters;
  for (const Index vertex : vertices) {
    const Index of_vertex = cluster(level, vertex);
    if (clusters.empty() || clusters.back() != of_vertex) clusters.push_back(of_vertex);
  }
  sort_unique(clusters);
  clusters = with_neighbours(neighbours(level), clusters);
  for (;; ++level) {
    update_means(level, clusters);
    if (level + 1 == size()) return;
    for (Index& cluster : clusters) cluster = parent(level, cluster);
    sort_unique(clusters);
  }
}

}  // namespace burin
