// Computes the nodes of base surfaces on demand, by the fits of base_fits.h, and projects points. A node is
// smoothed twice: the second time removes most of what remains of short waves and hardly reduces longer ones.
// The result of the first time is so smooth that the clusters of the next level, a quarter as many, represent
// it well enough for the second. A node costs O(clusters within the reach); of the many that rows of slivers
// have there, some stand for all.
#include <burin/base/parallel.h>
#include <burin/base/sort_unique.h>
#include <burin/surface/base_surface/base_fits.h>
#include <burin/surface/base_surface/base_surface.h>
#include <burin/surface/base_surface/cell_set.h>
#include <burin/surface/base_surface/evenly_chosen.h>
#include <burin/surface/geometry/quadratic_fit.h>
#include <burin/surface/topology/connected_nodes.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// The distance within which heights are fitted, in radii, and those within which paraboloids are fitted and
/// blended, in spacings.
constexpr double reach_over_radius = 0.55, ring_over_spacing = 2.1, blend_over_spacing = 1.6;

/// Lower limits of the latter two, in edges, for regions where nodes are far from each other.
constexpr double ring_over_edge = 1.4, blend_over_edge = 1.3;

/// Fewest edges per radius on the level that is smoothed once, if it is coarser than the level of the nodes.
constexpr double fewest_coarse_edges = 4.2;

/// Members of a cluster lie within this share of a spacing of its mean, with few exceptions.
constexpr double cluster_extent = 0.75;

/// Of the neighbours of a node that has more than this, so many stand for all, evenly chosen: the hub of a
/// fan would cost in proportion to the square of its spokes.
constexpr std::size_t most_neighbours = 64;

/// Of the samples around a group that has more than the former, the latter number stands for all, evenly
/// chosen. Evenly spread vertices give less than 1000, on both sides of a plate less than 2000. At the rim of
/// a fan all vertices are within the reach of each other.
constexpr std::size_t most_samples = 2048, standing_samples = 512;

double squared_distance(const Vec3f& a, const Vec3f& b) { return static_cast<double>((a - b).squaredNorm()); }

}  // namespace

bool BaseSurface::set_radius(double radius, bool fine) {
  // As in models of CAD with dense rims: vertices do not represent what lies between them.
  if (!fine && levels_->longest_edge() > 2 * radius) return false;
  const auto coarsest = [&](double edges) {
    std::size_t level = levels_->size() - 1;
    while (level > 0 && !(levels_->spacing(level) * edges <= radius)) --level;
    return level;
  };
  level_ = coarsest(fewest_edges);
  coarse_level_ = std::clamp(coarsest(fewest_coarse_edges), level_, level_ + 1);
  if (level_ == 0 && !(levels_->spacing(0) * fewest_own_edges <= radius)) return false;
  const double reach = reach_over_radius * radius;
  if (reach == reach_) return true;
  group_level_ = std::min(level_ + 2, levels_->size() - 1);
  reach_ = reach;
  widest_ = 0;
  ring_ = ring_over_spacing * spacing();
  means_.restart(node_count());
  once_.restart(levels_->neighbours(coarse_level_).rows());
  twice_.restart(node_count());
  patches_.restart(node_count());
  return true;
}

void BaseSurface::forget(std::span<const Index> moved_vertices, double distance) {
  if (reach_ == 0) return;
  // Smoothing moves a position by about half a reach at most.
  const double around = 3 * std::max(levels_->spacing(group_level_), widest_.load());
  CellSet near(2.5 * reach_ + ring_ + around + distance);
  for (const Index vertex : moved_vertices) near.add(surface_->positions[vertex]);
  const auto stale = [&](const auto& at) { return near.holds(at.position); };
  means_.forget_if(stale);
  once_.forget_if(stale);
  twice_.forget_if(stale);
  patches_.forget_if(stale);
}

namespace {

void append(std::vector<Index>& to, const std::vector<Index>& what) {
  to.insert(to.end(), what.begin(), what.end());
}

}  // namespace

/// Computes stage by stage, so that threads rarely compute the same value twice.
void BaseSurface::prepare(std::span<const Ball> balls) {
  Missing missing;
  for (const Ball& ball : balls) {
    const Missing here = missing_in(ball);
    append(missing.once, here.once);
    append(missing.twice, here.twice);
    append(missing.patches, here.patches);
  }
  const auto make_all = [&](std::vector<Index>& groups, std::size_t level, const auto& make) {
    sort_unique(groups);
    parallel_blocks(groups.size(), 1, [&](std::size_t i, std::size_t) {
      make(levels_->first_member(group_level_, groups[i], level));
    });
  };
  make_all(missing.once, coarse_level_, [this](Index cluster) { once(cluster); });
  make_all(missing.twice, level_, [this](Index node) { twice(node); });
  make_all(missing.patches, level_, [this](Index node) { patch(node); });
}

BaseSurface::Missing BaseSurface::missing_in(const Ball& ball) const {
  const double of_patches = ball.radius + spacing(), of_twice = of_patches + ring_,
               of_once = of_twice + reach_;
  Missing missing;
  const auto look_at = [&](Index group) {
    const double away = squared_distance(levels_->mean(group_level_, group).position, ball.middle);
    const auto needs = [&](double within, const auto& known, std::size_t level) {
      return away <= within * within && !known.find(levels_->first_member(group_level_, group, level));
    };
    if (needs(of_once, once_, coarse_level_)) missing.once.push_back(group);
    if (needs(of_twice, twice_, level_)) missing.twice.push_back(group);
    if (needs(of_patches, patches_, level_)) missing.patches.push_back(group);
    return away <= of_once * of_once;
  };
  const std::array start{levels_->ancestor(level_, ball.near, group_level_)};
  look_at(start[0]);
  ConnectedNodes connected;
  connected.find(levels_->neighbours(group_level_), start, look_at);
  return missing;
}

BaseSurface::Sample BaseSurface::mean(Index node) {
  const auto of_levels = [&] {
    const ClusterMean mean = levels_->mean(level_, node);
    return Sample{mean.position, mean.area, mean.spread};
  };
  if (level_ > 0) return of_levels();  // coarser levels store their means
  if (const Sample* known = means_.find(node)) return *known;
  const Sample sample = of_levels();
  means_.put(node, sample);
  return sample;
}

BaseSurface::Sample BaseSurface::once(Index cluster) {
  if (const Sample* known = once_.find(cluster)) return *known;
  return make_group(
      once_, cluster, {coarse_level_, level_, reach_},
      [this](Index member) {
        const ClusterMean mean = levels_->mean(coarse_level_, member);
        return Sample{mean.position, mean.area};
      },
      [this](Index node) { return mean(node); },
      [this](const Sample& origin, Index, const SurfaceSamples& samples) {
        const Sample from{origin.position, normal_around(origin.position, reach_, samples)};
        const Sample at = smoothed(from, reach_, samples);
        return Sample{at.position, std::max(origin.up.dot(at.up), 0.F) * at.up};
      });
}

/// Smooths a node a second time, starting from its projection to the tangent plane of its coarse cluster.
BaseSurface::Sample BaseSurface::twice(Index node) {
  if (const Sample* known = twice_.find(node)) return *known;
  return make_group(
      twice_, node, {level_, coarse_level_, reach_},
      [this](Index member) {
        const Sample beside = once(levels_->ancestor(level_, member, coarse_level_));
        const Vec3f before = mean(member).position, normal = beside.up.stableNormalized();
        return Sample{before - (before - beside.position).dot(normal) * normal, normal};
      },
      [this](Index cluster) { return once(cluster); },
      [this](const Sample& origin, Index, const SurfaceSamples& samples) {
        return smoothed(origin, reach_, samples);
      });
}

BasePatch BaseSurface::patch(Index node) {
  if (const BasePatch* known = patches_.find(node)) return *known;
  const auto width = [this](Index member) { return std::max(ring_, ring_over_edge * edge(member)); };
  double widest = ring_;
  levels_->for_each_member(group_level_, levels_->ancestor(level_, node, group_level_), level_,
                           [&](Index member) { widest = std::max(widest, width(member)); });
  return make_group(
      patches_, node, {level_, level_, widest}, [this](Index member) { return twice(member); },
      [this](Index member) { return twice(member); },
      [&](const Sample& origin, Index member, const SurfaceSamples& samples) {
        return fitted_patch(origin, width(member), samples);
      });
}

/// The neighbours of a node, or those that stand for them.
std::vector<Index> BaseSurface::ring(Index node) const {
  return evenly_chosen<Index>(neighbours()[node], most_neighbours);
}

/// The mean length of a node's edges, which exceeds the spacing where the surface itself is coarser; 0 when
/// the node has no edges.
double BaseSurface::edge(Index node) {
  const std::vector<Index> around = ring(node);
  if (around.empty()) return 0;
  const Vec3f here = twice(node).position;
  double sum = 0;
  for (const Index other : around) sum += std::sqrt(squared_distance(twice(other).position, here));
  const double mean = sum / static_cast<double>(around.size());
  note_width(mean);
  return mean;
}

void BaseSurface::note_width(double width) {
  double known = widest_.load();
  while (known < width && !widest_.compare_exchange_weak(known, width)) {
  }
}

/// Computes the values of all members of the wanted one's group, since they share most of their samples.
template <class Value, class OriginOf, class SampleOf, class Make>
Value BaseSurface::make_group(OnDemand<Value>& values, Index wanted, const Making& making,
                              const OriginOf& origin_of, const SampleOf& sample_of, const Make& make) {
  const Index group = levels_->ancestor(making.level, wanted, group_level_);
  std::vector<Index> members;
  std::vector<Sample> origins;
  levels_->for_each_member(group_level_, group, making.level, [&](Index member) {
    members.push_back(member);
    origins.push_back(origin_of(member));
  });
  const SurfaceSamples samples = samples_around(group, origins, making, sample_of);
  Value of_wanted{};
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Value value = make(origins[i], members[i], samples);
    if (members[i] == wanted) of_wanted = value;
    values.put(members[i], value);
  }
  return of_wanted;
}

/// The samples of clusters that are connected within a ball; the ball holds everything within reach of any
/// origin.
template <class SampleOf>
SurfaceSamples BaseSurface::samples_around(Index group, std::span<const Sample> origins, const Making& making,
                                           const SampleOf& sample_of) {
  Eigen::AlignedBox3f box;
  for (const Sample& origin : origins) box.extend(origin.position);
  const Vec3f middle = box.center();
  double extent = 0;
  for (const Sample& origin : origins) extent = std::max(extent, squared_distance(origin.position, middle));
  note_width(std::sqrt(extent));
  const double about = making.reach + std::sqrt(extent);
  // The search walks from group to group, so the ball is widened by the extent of a group.
  const double farthest = about + cluster_extent * levels_->spacing(group_level_);
  std::vector<Sample> samples;
  ConnectedNodes connected;
  for (const Index other :
       connected.find(levels_->neighbours(group_level_), std::array{group}, [&](Index one) {
         return squared_distance(levels_->mean(group_level_, one).position, middle) <= farthest * farthest;
       })) {
    levels_->for_each_member(group_level_, other, making.sample_level, [&](Index member) {
      const Sample sample = sample_of(member);
      if (squared_distance(sample.position, middle) <= about * about) samples.push_back(sample);
    });
  }
  if (samples.size() > most_samples) samples = evenly_chosen<Sample>(samples, standing_samples);
  return SurfaceSamples(samples);
}

/// The neighbours of a node among which the one that is nearest to a point is: of many the one whose mean is.
std::vector<Index> BaseSurface::towards(Index node, const Vec3f& point) const {
  const std::span<const Index> all = neighbours()[node];
  if (all.size() <= most_neighbours) return {all.begin(), all.end()};
  return {*std::ranges::min_element(
      all, {}, [&](Index other) { return squared_distance(levels_->mean(level_, other).position, point); })};
}

Index BaseSurface::nearest(Index near, const Vec3f& point) {
  for (;;) {
    const Vec3f normal = patch(near).normal;
    const auto squared = [&](Index node) {
      const BasePatch at = patch(node);
      return at.normal.dot(normal) > 0 ? squared_distance(at.position, point)
                                       : std::numeric_limits<double>::infinity();
    };
    const std::vector<Index> around = towards(near, point);
    const auto best = std::ranges::min_element(around, {}, squared);
    if (best == around.end() || !(squared(*best) < squared(near))) return near;
    near = *best;
  }
}

/// Computes the nodes within a radius of each of these nodes that is missing: a query is usually followed by
/// a stroke at the same place. Nodes farther from that place are left to be computed one by one.
void BaseSurface::prepare_around(std::span<const Index> nodes, const Vec3f& position) {
  const double radius = reach_ / static_cast<double>(reach_over_radius);
  for (const Index node : nodes) {
    if (patches_.find(node)) continue;
    const Vec3f middle = levels_->mean(level_, node).position;
    if (squared_distance(middle, position) <= radius * radius)
      prepare(std::array{Ball{middle, radius, node}});
  }
}

std::vector<Index> BaseSurface::two_rings(Index node) const {
  std::vector<Index> nodes{node};
  for (const Index one : ring(node)) {
    nodes.push_back(one);
    append(nodes, ring(one));
  }
  sort_unique(nodes);
  return nodes;
}

std::vector<BaseSurface::Weighted> BaseSurface::around(Index node, const Vec3f& position) {
  const double reach = std::max(blend_over_spacing * spacing(), blend_over_edge * edge(node));
  const Vec3f normal = patch(node).normal;
  std::vector<Weighted> weighted;
  for (const Index other : two_rings(node)) {
    const BasePatch at = patch(other);
    if (!(at.normal.dot(normal) > same_side)) continue;
    const double weight = bump_weight(squared_distance(at.position, position) / (reach * reach));
    if (weight > 0) weighted.push_back({at, weight});
  }
  return weighted;
}

BasePoint BaseSurface::project(Index near, const Vec3f& point) {
  prepare_around(std::array{near}, point);
  const Index node = nearest(near, point);
  const BasePatch own = patch(node);
  // Paraboloids extend beyond the end of the surface, so the distance from the node is limited.
  constexpr double farthest = 2;  // in spacings, or in edges where those are longer
  const auto extent = static_cast<float>(farthest * std::max(spacing(), edge(node)));
  const BasePatch::Local<float> foot = own.foot_within(point, extent);
  const Vec3f middle = own.point_at(foot);
  Vec3d position = Vec3d::Zero(), normal = Vec3d::Zero();
  double weights = 0;
  prepare_around(two_rings(node), middle);
  for (const auto& [at, weight] : around(node, middle)) {
    const BasePatch::Local<float> there = at.foot_within(point, extent);
    position += weight * at.point_at(there).cast<double>();
    normal += weight * at.normal_at(there).cast<double>();
    weights += weight;
  }
  if (!(weights > 0 && normal.squaredNorm() > 0)) return {middle, own.normal_at(foot), node};
  return {(position / weights).cast<float>(), normal.normalized().cast<float>(), node};
}

}  // namespace burin
