// Base surfaces by moving least squares over clusters [Lancaster and Salkauskas 1981]. The height over the
// plane across the mean normal is a weighted least-squares quadratic in (x, y), whose value in the middle
// keeps heights of third degree and nearly removes waves shorter than the reach; twice, since a second time
// removes as much of what came through and adds as little to the loss of longer waves. What is left after the
// first time is so smooth that clusters of the next level, a quarter as many, tell it to the second.
// Clusters count by their area as seen along the normal, which is what an integral over (x, y) asks for
// however steep the relief is.
#include <burin/base/parallel.h>
#include <burin/base/sort_unique.h>
#include <burin/surface/base_surface.h>
#include <burin/surface/cell_set.h>
#include <burin/surface/connected_nodes.h>
#include <burin/surface/quadratic_fit.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

/// Over which heights are fitted, in radii, and over which paraboloids are, and are blended, in spacings.
constexpr double reach_over_radius = 0.55, ring_over_spacing = 2.5, blend_over_spacing = 1.6;

/// Members of a cluster lie within this share of a spacing of its mean, and seldom farther.
constexpr double cluster_extent = 0.75;

/// Normals of the base surface that differ by more (cosine) do not belong to one patch.
constexpr float same_side = 0.2F;

Vec3f local(const Vec3f& origin, const Vec3f& axis_x, const Vec3f& axis_y, const Vec3f& normal,
            const Vec3f& point) {
  const Vec3f way = point - origin;
  return {way.dot(axis_x), way.dot(axis_y), way.dot(normal)};
}

double squared_distance(const Vec3f& a, const Vec3f& b) { return static_cast<double>((a - b).squaredNorm()); }

/// The normal of a height over a plane that has these slopes.
Vec3f tilted(const Vec3f& normal, const Vec3f& axis_x, const Vec3f& axis_y,
             const QuadraticFit::Terms& height) {
  return (normal - static_cast<float>(height[1]) * axis_x - static_cast<float>(height[2]) * axis_y)
      .normalized();
}

}  // namespace

bool BaseSurface::set_radius(double radius) {
  const auto coarse_enough = [&](std::size_t level) {
    return levels_->spacing(level) * (level == 0 ? fewest_own_edges : fewest_edges) <= radius;
  };
  std::size_t level = levels_->size() - 1;
  while (level > 0 && !coarse_enough(level)) --level;
  if (!coarse_enough(level)) return false;
  const double reach = reach_over_radius * radius;
  if (reach == reach_) return true;
  level_ = level;
  const bool has_coarser = level + 1 < levels_->size() && levels_->spacing(level) * fewest_edges <= radius;
  coarse_level_ = has_coarser ? level + 1 : level;
  group_level_ = std::min(coarse_level_ + 1, levels_->size() - 1);
  reach_ = reach;
  ring_ = ring_over_spacing * spacing();
  means_.restart(node_count());
  once_.restart(levels_->neighbours(coarse_level_).rows());
  twice_.restart(node_count());
  patches_.restart(node_count());
  return true;
}

void BaseSurface::forget(std::span<const Index> moved_vertices, double distance) {
  if (reach_ == 0) return;
  // What is smoothed lies within about half a reach of where it was.
  CellSet near(2.5 * reach_ + ring_ + 3 * levels_->spacing(group_level_) + distance);
  for (const Index vertex : moved_vertices) near.add(surface_->positions[vertex]);
  const auto stale = [&](const auto& at) { return near.holds(at.position); };
  means_.forget_if(stale);
  once_.forget_if(stale);
  twice_.forget_if(stale);
  patches_.forget_if(stale);
}

/// Stage by stage, so that no thread has to make what another is making already.
void BaseSurface::prepare(Index near, const Vec3f& point, double distance) {
  const double size = cluster_extent * levels_->spacing(group_level_);
  const double of_patches = distance + size, of_twice = of_patches + ring_ + 2 * size,
               of_once = of_twice + reach_ + 2 * size;
  const std::vector<Group> groups =
      groups_within(levels_->ancestor(level_, near, group_level_), point, of_once);
  const auto stage = [&](double within, std::size_t level, const auto& known, const auto& make) {
    std::vector<Index> missing;  // a member of each group
    for (const Group& group : groups) {
      if (group.squared_distance > within * within) continue;
      const Index member = levels_->first_member(group_level_, group.cluster, level);
      if (!known.find(member)) missing.push_back(member);
    }
    parallel_blocks(missing.size(), 1, [&](std::size_t i, std::size_t) { make(missing[i]); });
  };
  stage(of_once, coarse_level_, once_, [this](Index cluster) { once(cluster); });
  stage(of_twice, level_, twice_, [this](Index node) { twice(node); });
  stage(of_patches, level_, patches_, [this](Index node) { patch(node); });
}

/// Those with means so near to the point that are connected with the start.
std::vector<BaseSurface::Group> BaseSurface::groups_within(Index start, const Vec3f& point,
                                                           double distance) const {
  const auto squared = [&](Index group) {
    return squared_distance(levels_->mean(group_level_, group).position, point);
  };
  std::vector<Group> groups{{start, squared(start)}};
  ConnectedNodes connected;
  connected.find(levels_->neighbours(group_level_), std::array{start}, [&](Index group) {
    const double away = squared(group);
    const bool within = away <= distance * distance;
    if (within) groups.push_back({group, away});
    return within;
  });
  return groups;
}

BaseSurface::Sample BaseSurface::mean(Index node) {
  if (const Sample* known = means_.find(node)) return *known;
  const ClusterMean mean = levels_->mean(level_, node);
  const Sample sample{mean.position, mean.area};
  means_.put(node, sample);
  return sample;
}

BaseSurface::Sample BaseSurface::once(Index cluster) {
  if (const Sample* known = once_.find(cluster)) return *known;
  return make_group<SurfaceSamples>(
      once_, cluster, {coarse_level_, level_, reach_},
      [this](Index member) {
        const ClusterMean mean = levels_->mean(coarse_level_, member);
        return Sample{mean.position, mean.area};
      },
      [this](Index node) { return mean(node); },
      [this](const Sample& origin, const SurfaceSamples& samples) {
        const Sample at = smoothed(origin.position, samples);
        return Sample{at.position, std::max(origin.up.dot(at.up), 0.F) * at.up};
      });
}

/// From where the coarse cluster's tangent plane has the node.
BaseSurface::Sample BaseSurface::twice(Index node) {
  if (const Sample* known = twice_.find(node)) return *known;
  return make_group<SurfaceSamples>(
      twice_, node, {level_, coarse_level_, reach_},
      [this](Index member) {
        const Sample before = mean(member), beside = once(levels_->ancestor(level_, member, coarse_level_));
        const Vec3f normal = beside.up.stableNormalized();
        return Sample{before.position - (before.position - beside.position).dot(normal) * normal, before.up};
      },
      [this](Index cluster) { return once(cluster); },
      [this](const Sample& origin, const SurfaceSamples& samples) {
        return smoothed(origin.position, samples);
      });
}

BasePatch BaseSurface::patch(Index node) {
  if (const BasePatch* known = patches_.find(node)) return *known;
  return make_group<std::vector<Sample>>(
      patches_, node, {level_, level_, ring_}, [this](Index member) { return twice(member); },
      [this](Index member) { return twice(member); },
      [this](const Sample& origin, std::span<const Sample> samples) { return fitted(origin, samples); });
}

/// Makes the values of all members of the wanted one's group, which have most of their samples in common.
template <class Samples, class Value, class OriginOf, class SampleOf, class Make>
Value BaseSurface::make_group(OnDemand<Value>& values, Index wanted, const Making& making,
                              const OriginOf& origin_of, const SampleOf& sample_of, const Make& make) {
  const Index group = levels_->ancestor(making.level, wanted, group_level_);
  std::vector<Index> members;
  std::vector<Sample> origins;
  levels_->for_each_member(group_level_, group, making.level, [&](Index member) {
    members.push_back(member);
    origins.push_back(origin_of(member));
  });
  const Samples samples(samples_around(group, origins, making, sample_of));
  Value of_wanted{};
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Value value = make(origins[i], samples);
    if (members[i] == wanted) of_wanted = value;
    values.put(members[i], value);
  }
  return of_wanted;
}

/// Those of clusters that are connected within a ball which holds what is within reach of any origin.
template <class SampleOf>
std::vector<BaseSurface::Sample> BaseSurface::samples_around(Index group, std::span<const Sample> origins,
                                                             const Making& making,
                                                             const SampleOf& sample_of) const {
  Eigen::AlignedBox3f box;
  for (const Sample& origin : origins) box.extend(origin.position);
  const Vec3f middle = box.center();
  double extent = 0;
  for (const Sample& origin : origins) extent = std::max(extent, squared_distance(origin.position, middle));
  const double about = making.reach + std::sqrt(extent);
  // Going from cluster to cluster of the level above is going in strides.
  const std::size_t level = std::min(making.sample_level + 1, group_level_);
  const double farthest = about + cluster_extent * levels_->spacing(level);
  std::vector<Index> starts;
  levels_->for_each_member(group_level_, group, level, [&](Index start) { starts.push_back(start); });
  std::vector<Sample> samples;
  ConnectedNodes connected;
  for (const Index cluster : connected.find(levels_->neighbours(level), starts, [&](Index one) {
         return squared_distance(levels_->mean(level, one).position, middle) <= farthest * farthest;
       })) {
    levels_->for_each_member(level, cluster, making.sample_level, [&](Index member) {
      const Sample sample = sample_of(member);
      if (squared_distance(sample.position, middle) <= about * about) samples.push_back(sample);
    });
  }
  return samples;
}

/// A point brought onto the paraboloid that fits the samples around it best, and its normal: zero where their
/// area cancels out.
BaseSurface::Sample BaseSurface::smoothed(const Vec3f& origin, const SurfaceSamples& samples) const {
  using Lanes = SurfaceSamples::Lanes;
  const auto whole = static_cast<float>(reach_ * reach_);
  Vec3f area = Vec3f::Zero();
  for (const SurfaceSamples::Block& block : samples.blocks()) {
    const Lanes counts = (4 * block.from(origin).squared_length() <= whole).cast<float>();
    area += Vec3f((counts * block.up.x).sum(), (counts * block.up.y).sum(), (counts * block.up.z).sum());
  }
  if (!(area.squaredNorm() > 0)) return {origin, Vec3f::Zero()};
  const Vec3f normal = area.normalized(), axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
  QuadraticFit fit(reach_);
  for (const SurfaceSamples::Block& block : samples.blocks()) {
    const SurfaceSamples::Vectors way = block.from(origin);
    // Where a sheet turns away, what is connected beyond it is another one.
    const Lanes seen = block.up.dot(normal).max(0.F) * (way.squared_length() <= whole).cast<float>();
    if (!(seen.maxCoeff() > 0)) continue;
    const Lanes x = way.dot(axis_x), y = way.dot(axis_y), z = way.dot(normal);
    constexpr int half = QuadraticFit::lanes;
    for (int lane = 0; lane < SurfaceSamples::lanes; lane += half) {
      const auto part = [lane](const Lanes& all) { return all.segment<half>(lane).cast<double>().eval(); };
      fit.add(part(x), part(y), part(z), part(seen));
    }
  }
  const QuadraticFit::Terms height = fit.solve();
  return {origin + static_cast<float>(height[0]) * normal, tilted(normal, axis_x, axis_y, height)};
}

BasePatch BaseSurface::fitted(const Sample& origin, std::span<const Sample> samples) const {
  Vec3f normal = origin.up.isZero(0) ? Vec3f::UnitZ() : origin.up;
  for (int round = 0;; ++round) {
    const Vec3f axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
    QuadraticFit fit(ring_);
    for (const Sample& sample : samples)
      if (squared_distance(sample.position, origin.position) <= ring_ * ring_ &&
          sample.up.dot(origin.up) > same_side)
        fit.add(local(origin.position, axis_x, axis_y, normal, sample.position), 1);
    const QuadraticFit::Terms height = fit.solve();
    if (round == 1)
      return {origin.position,
              normal,
              axis_x,
              static_cast<float>(height[3]),
              static_cast<float>(height[4]),
              static_cast<float>(height[5])};
    normal = tilted(normal, axis_x, axis_y, height);
  }
}

Index BaseSurface::nearest(Index near, const Vec3f& point) {
  for (;;) {
    const Vec3f normal = patch(near).normal;
    const auto squared = [&](Index node) {
      const BasePatch at = patch(node);
      return at.normal.dot(normal) > 0 ? squared_distance(at.position, point)
                                       : std::numeric_limits<double>::infinity();
    };
    const std::span<const Index> around = neighbours()[near];
    const auto best = std::ranges::min_element(around, {}, squared);
    if (best == around.end() || !(squared(*best) < squared(near))) return near;
    near = *best;
  }
}

/// Where one of these nodes is missing: whoever asks for a place is going to draw there.
void BaseSurface::prepare_around(std::span<const Index> nodes) {
  const double radius = reach_ / static_cast<double>(reach_over_radius);
  for (const Index node : nodes)
    if (!patches_.find(node)) prepare(node, mean(node).position, radius);
}

BasePoint BaseSurface::project(Index near, const Vec3f& point) {
  prepare_around(std::array{near});
  const Index node = nearest(near, point);
  const BasePatch own = patch(node);
  // Paraboloids go on where the surface ends.
  constexpr double farthest = 2;  // spacings that a place may be from its node
  const auto extent = static_cast<float>(farthest * spacing());
  const BasePatch::Local<float> foot = own.foot_within(point, extent);
  const Vec3f middle = own.place(foot);
  const double reach = blend_over_spacing * spacing();
  std::vector<Index> two_rings{node};
  for (const Index one : neighbours()[node]) {
    two_rings.push_back(one);
    for (const Index two : neighbours()[one]) two_rings.push_back(two);
  }
  sort_unique(two_rings);
  prepare_around(two_rings);
  Vec3d position = Vec3d::Zero(), normal = Vec3d::Zero();
  double weights = 0;
  for (const Index other : two_rings) {
    const BasePatch at = patch(other);
    if (!(at.normal.dot(own.normal) > same_side)) continue;
    const double weight = bump_weight(squared_distance(at.position, middle) / (reach * reach));
    if (!(weight > 0)) continue;
    const BasePatch::Local<float> there = at.foot_within(point, extent);
    position += weight * at.place(there).cast<double>();
    normal += weight * at.normal_at(there).cast<double>();
    weights += weight;
  }
  if (!(weights > 0 && normal.squaredNorm() > 0)) return {middle, own.normal_at(foot), node};
  return {(position / weights).cast<float>(), normal.normalized().cast<float>(), node};
}

}  // namespace burin
