// Builds levels by clustering. In the order of the space-filling curve, each vertex that no cluster has
// reached becomes the middle of a new cluster, which takes all vertices within its reach along edges that are
// not nearer to another middle. This is a Poisson disc sampling with its Voronoi cells, by bounded runs of
// Dijkstra's algorithm [Dijkstra 1959]. Ranges of consecutive vertices are clustered concurrently; no cluster
// crosses their borders. A level costs about O(n) for the n vertices of the level below; each level has a
// quarter as many.
#include <burin/base/counting_sort.h>
#include <burin/base/index_set.h>
#include <burin/surface/base_surface/surface_levels.h>
#include <burin/surface/geometry/triangle_shape.h>
#include <burin/surface/topology/collect_rows.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

namespace burin {
namespace {

constexpr Index vertices_a_range = 32768, rows_per_block = 4096, clusters_per_block = 256;

/// Levels with fewer clusters are too coarse for any stroke.
constexpr Index fewest_clusters = 64;

/// The reach of clusters from their middles, in typical edges of the level below. The lower limit includes
/// the neighbours, which gives clusters of 4 to 5 vertices. If vertices are sparse in some regions the reach
/// is longer, so that few clusters are a single vertex, but not so long that dense regions skip a level.
constexpr double least_reach_over_edge = 1.22, most_reach_over_edge = 1.7;

/// The vertices and edges of a level.
struct Graph {
  std::span<const Vec3f> positions;
  const Csr& neighbours;
};

/// The clusters of one range of vertices.
class RangeClusters {
 public:
  /// Numbers the clusters from 0 in `cluster_of`. It writes only the elements of its range in `cluster_of`
  /// and `distance`.
  RangeClusters(const Graph& graph, float reach, std::span<Index> cluster_of, std::span<float> distance)
      : graph_(graph), reach_(reach), cluster_of_(cluster_of), distance_(distance) {}

  /// Clusters the vertices from `begin` to `end`; returns the clusters' middles.
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

/// Sets level.cluster_of; returns the middle of each cluster.
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
  level.neighbours = collect_rows(clusters, rows_per_block, [&](Index cluster, UnsetVector<Index>& out) {
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    for (const Index member : level.members[cluster])
      for (const Index neighbour : graph.neighbours[member])
        if (level.cluster_of[neighbour] != cluster) out.push_back(level.cluster_of[neighbour]);
    std::sort(out.begin() + first, out.end());
    out.erase(std::unique(out.begin() + first, out.end()), out.end());
  });
}

/// The area of a point of a point set: its share of the disc that holds it and its neighbours. If n points
/// are evenly distributed in a disc of radius R, the mean square of their distances from the middle is R^2 /
/// 2.
double area_of_point(const Surface& surface, Index point) {
  double squares = 0, count = 1;
  for (const Index neighbour : surface.neighbours[point]) {
    squares += static_cast<double>((surface.positions[neighbour] - surface.positions[point]).squaredNorm());
    ++count;
  }
  return 2 * std::numbers::pi * squares / (count * count);
}

/// The area of a vertex: a third of the triangles around it.
double area_of_vertex(const Surface& surface, Index vertex) {
  double doubled = 0;
  for (const Index index : surface.incident[vertex]) {
    const auto& [a, b, c] = surface.triangles[index];
    const Vec3f& at = surface.positions[a];
    doubled += static_cast<double>((surface.positions[b] - at).cross(surface.positions[c] - at).norm());
  }
  return doubled / 6;
}

/// The edge length of a lattice of equilateral triangles with this area per vertex.
double edge_of(double area) { return std::sqrt(2 / std::sqrt(3.) * area); }

/// Calls visit(vertex, typical edge length) for an even sample of the vertices. Vertices without area are
/// skipped.
template <class AreaOf, class Visit>
void for_some_edges(Index vertices, const AreaOf& area_of, const Visit& visit) {
  constexpr Index most_vertices = 65536;
  for (Index vertex = 0; vertex < vertices; vertex += vertices / most_vertices + 1)
    if (const double area = area_of(vertex); area > 0) visit(vertex, edge_of(area));
}

/// The quantile of the lengths at this share; 0 if there are none.
double quantile(std::vector<double> lengths, double share) {
  if (lengths.empty()) return 0;
  const auto place =
      lengths.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(lengths.size()));
  std::nth_element(lengths.begin(), place, lengths.end());
  return *place;
}

/// Shares for quantile().
constexpr double dense = 0.1, median = 0.5, sparse = 0.9;

double reach_over(const std::vector<double>& edges) {
  const double typical = quantile(edges, median);
  return std::clamp(quantile(edges, sparse), least_reach_over_edge * typical, most_reach_over_edge * typical);
}

/// The longest edges of an even sample of the triangles: their median, each weighted by its triangle's area.
double median_longest_edge(const Surface& surface) {
  constexpr std::size_t most_triangles = 65536;
  std::vector<std::pair<double, double>> edges;  // and areas
  double rest = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); i += surface.triangles.size() / most_triangles + 1) {
    const auto& [a, b, c] = surface.triangles[i];
    const Vec3f ab = surface.positions[b] - surface.positions[a],
                ac = surface.positions[c] - surface.positions[a];
    const double area = static_cast<double>(ab.cross(ac).norm()) / 2;
    edges.emplace_back(static_cast<double>(std::max({ab.norm(), ac.norm(), (ac - ab).norm()})), area);
    rest += area / 2;
  }
  std::ranges::sort(edges);
  for (const auto& [edge, area] : edges)
    if ((rest -= area) <= 0) return edge;
  return 0;
}

/// The ClusterMean of a single vertex, whose area is a third of the triangles around it.
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

}  // namespace

SurfaceLevels::SurfaceLevels(const Surface& surface) : surface_(&surface) {
  std::vector<double> edges;  // of the last level
  for_some_edges(
      surface.vertex_count(),
      [&](Index vertex) {
        return surface.is_point_set() ? area_of_point(surface, vertex) : area_of_vertex(surface, vertex);
      },
      [&](Index, double edge) { edges.push_back(edge); });
  edge_ = quantile(edges, dense);
  longest_edge_ = median_longest_edge(surface);
  std::vector<Vec3f> middles;  // of the last level
  while (!edges.empty()) {
    const Graph graph = coarser_.empty() ? Graph{surface.positions, surface.neighbours}
                                         : Graph{middles, coarser_.back().neighbours};
    SurfaceLevel level;
    const std::vector<Index> vertices = make_clusters(graph, reach_over(edges), level);
    const auto clusters = static_cast<Index>(vertices.size());
    if (clusters < fewest_clusters || clusters == graph.positions.size()) return;
    connect(graph, clusters, level);
    std::vector<Vec3f> positions;
    for (const Index vertex : vertices) positions.push_back(graph.positions[vertex]);
    middles = std::move(positions);
    coarser_.push_back(std::move(level));
    std::vector<Index> all(clusters);
    std::iota(all.begin(), all.end(), Index{0});
    coarser_.back().means.resize(clusters);
    update_means(coarser_.size(), all);
    edges = measure_last();
    if (!(spacing(size() - 1) > spacing(size() - 2))) {
      coarser_.pop_back();
      return;
    }
  }
}

/// Sets the spacing of the last level, or 0 if all its clusters have only one or two vertices; returns
/// typical edge lengths of some of its clusters.
std::vector<double> SurfaceLevels::measure_last() {
  constexpr std::size_t several = 3;
  const std::size_t last = size() - 1;
  std::vector<double> edges, of_several;
  for_some_edges(
      neighbours(last).rows(), [&](Index cluster) { return area_around(last, cluster); },
      [&](Index cluster, double edge) {
        edges.push_back(edge);
        if (members(last, cluster).size() >= several) of_several.push_back(edge);
      });
  coarser_.back().spacing = quantile(std::move(of_several), median);
  return edges;
}

/// The mean area of a cluster and its neighbours, since the sizes of neighbouring clusters differ.
double SurfaceLevels::area_around(std::size_t level, Index cluster) const {
  double sum = static_cast<double>(mean(level, cluster).area.norm());
  for (const Index neighbour : neighbours(level)[cluster])
    sum += static_cast<double>(mean(level, neighbour).area.norm());
  return sum / static_cast<double>(neighbours(level)[cluster].size() + 1);
}

ClusterMean SurfaceLevels::mean(std::size_t level, Index cluster) const {
  return level == 0 ? mean_of_vertex(*surface_, cluster) : coarser_[level - 1].means[cluster];
}

namespace {

/// Sums over the members of a cluster, weighted by area.
class MeanSums {
 public:
  /// Positions are summed relative to `origin` to limit rounding.
  explicit MeanSums(const Vec3f& origin) : origin_(origin) {}

  void add(const ClusterMean& member) {
    const Vec3d at = (member.position - origin_).cast<double>();
    const auto weight = static_cast<double>(member.area.norm());
    weights_ += weight;
    weighted_ += weight * at;
    squares_ += weight * at * at.transpose();
    spreads_ += weight * static_cast<double>(member.spread);
    plain_ += at;
    area_ += member.area.cast<double>();
    ++count_;
  }

  ClusterMean mean() const {
    const Vec3d at = weights_ > 0 ? Vec3d(weighted_ / weights_) : Vec3d(plain_ / count_);
    return {origin_ + at.cast<float>(), area_.cast<float>(),
            weights_ > 0 ? static_cast<float>(spread_about(at)) : 0};
  }

 private:
  /// The mean square of the members' distances from `at` along one axis of the cluster's plane, which is half
  /// of the mean square within the plane.
  double spread_about(const Vec3d& at) const {
    const Eigen::Matrix3d squares = squares_ / weights_ - at * at.transpose();
    const Vec3d normal = area_.stableNormalized();
    return spreads_ / weights_ + std::max(squares.trace() - normal.dot(squares * normal), 0.) / 2;
  }

  Vec3f origin_;
  Vec3d weighted_ = Vec3d::Zero(), plain_ = Vec3d::Zero(), area_ = Vec3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  double weights_ = 0, spreads_ = 0, count_ = 0;
};

}  // namespace

ClusterMean SurfaceLevels::mean_of_members(std::size_t level, Index cluster) const {
  const std::span<const Index> of_cluster = members(level, cluster);
  if (of_cluster.size() == 1) return mean(level - 1, of_cluster[0]);
  MeanSums sums(mean(level - 1, of_cluster[0]).position);
  for (const Index member : of_cluster) sums.add(mean(level - 1, member));
  return sums.mean();
}

void SurfaceLevels::update_means(std::size_t level, std::span<const Index> clusters) {
  std::vector<ClusterMean>& means = coarser_[level - 1].means;
  parallel_blocks(clusters.size(), clusters_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) means[clusters[i]] = mean_of_members(level, clusters[i]);
  });
}

/// Updates the clusters of moved vertices and of their neighbours, with whom they share triangles.
void SurfaceLevels::moved(std::span<const Index> vertices) {
  if (size() == 1) return;
  IndexSet stale(neighbours(1).rows());
  Index last = no_index;
  for (const Index vertex : vertices) {
    const Index of_vertex = cluster(1, vertex);
    if (std::exchange(last, of_vertex) == of_vertex) continue;
    stale.insert(of_vertex);
    for (const Index neighbour : neighbours(1)[of_vertex]) stale.insert(neighbour);
  }
  std::vector<Index> clusters;
  for (std::size_t level = 1;; ++level) {
    stale.drain(clusters);
    update_means(level, clusters);
    if (level + 1 == size()) return;
    for (const Index cluster : clusters) stale.insert(parent(level, cluster));
  }
}

}  // namespace burin
