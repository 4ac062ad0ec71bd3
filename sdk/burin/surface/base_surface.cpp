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

constexpr std::size_t nodes_a_block = 32;

/// Over which heights are fitted, in radii, and over which paraboloids are, and are blended, in spacings.
constexpr double reach_over_radius = 0.55, ring_over_spacing = 2.5, blend_over_spacing = 1.6;

/// Normals of the base surface that differ by more (cosine) do not belong to one patch.
constexpr float same_side = 0.2F;

Vec3f local(const Vec3f& origin, const Vec3f& axis_x, const Vec3f& axis_y, const Vec3f& normal,
            const Vec3f& point) {
  const Vec3f way = point - origin;
  return {way.dot(axis_x), way.dot(axis_y), way.dot(normal)};
}

double squared_distance(const Vec3f& a, const Vec3f& b) { return static_cast<double>((a - b).squaredNorm()); }

/// The normal of a height over a plane that has these slopes.
Vec3f tilted(const Vec3f& normal, const Vec3f& axis_x, const Vec3f& axis_y, const QuadraticFit::Terms& height) {
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
  CellSet near(2.5 * reach_ + ring_ + 4 * spacing() + distance);
  for (const Index vertex : moved_vertices) near.add(surface_->positions[vertex]);
  const auto stale = [&](const auto& at) { return near.holds(at.position); };
  means_.forget_if(stale);
  once_.forget_if(stale);
  twice_.forget_if(stale);
  patches_.forget_if(stale);
}

void BaseSurface::prepare(Index near, const Vec3f& point, double distance) {
  ConnectedNodes connected;
  const auto within = [&](Index node) {
    return squared_distance(vertex_of(node), point) <= distance * distance;
  };
  std::vector<Index> missing;
  for (const Index node : connected.find(neighbours(), std::array{near}, within))
    if (!patches_.made(node)) missing.push_back(node);
  std::ranges::sort(missing);
  parallel_blocks(missing.size(), nodes_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) patch(missing[i]);
  });
}

ClusterMean BaseSurface::mean(Index node) {
  return means_.get(node, [&] { return levels_->mean(level_, node); });
}

BaseSurface::Smoothed BaseSurface::once(Index cluster) {
  return once_.get(cluster, [&] {
    const std::array own{cluster};
    const bool coarser = coarse_level_ > level_;
    return smoothed(levels_->mean(coarse_level_, cluster).position, neighbours(),
                    coarser ? levels_->members(coarse_level_, cluster) : std::span<const Index>(own),
                    [this](Index node) {
                      const ClusterMean of_node = mean(node);
                      return Sample{of_node.position, of_node.area};
                    });
  });
}

BaseSurface::Smoothed BaseSurface::twice(Index node) {
  return twice_.get(node, [&] {
    const std::array start{coarse_level_ > level_ ? levels_->parent(level_, node) : node};
    const Smoothed beside = once(start[0]);
    const Vec3f position = mean(node).position;
    return smoothed(position - (position - beside.position).dot(beside.normal) * beside.normal,
                    levels_->neighbours(coarse_level_), start, [this](Index cluster) {
                      return Sample{once(cluster).position, levels_->mean(coarse_level_, cluster).area};
                    });
  });
}

/// A point near the samples brought onto the paraboloid that fits those around it best which are connected
/// with `starts`.
template <class SampleOf>
BaseSurface::Smoothed BaseSurface::smoothed(const Vec3f& origin, const Csr& neighbours,
                                            std::span<const Index> starts,
                                            const SampleOf& sample_of) const {
  ConnectedNodes connected;
  std::vector<Sample> samples;
  const auto gather = [&](const auto& counts) {
    samples.clear();
    for (const Index start : starts) samples.push_back(sample_of(start));
    connected.find(neighbours, starts, [&](Index node) {
      const Sample sample = sample_of(node);
      const bool near = squared_distance(sample.position, origin) <= reach_ * reach_ && counts(sample);
      if (near) samples.push_back(sample);
      return near;
    });
  };
  gather([](const Sample&) { return true; });
  Vec3f area = Vec3f::Zero();
  for (const Sample& sample : samples)
    if (4 * squared_distance(sample.position, origin) <= reach_ * reach_) area += sample.area;
  if (!(area.squaredNorm() > 0)) return {origin, Vec3f::Zero()};
  const Vec3f normal = area.normalized(), axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
  const auto faces_it = [&](const Sample& sample) { return sample.area.dot(normal) > 0; };
  // Where a sheet turns away, what is connected beyond it is another one.
  if (!std::ranges::all_of(samples, faces_it)) gather(faces_it);
  QuadraticFit fit(reach_);
  for (const Sample& sample : samples)
    fit.add(local(origin, axis_x, axis_y, normal, sample.position),
            std::max(static_cast<double>(sample.area.dot(normal)), 0.));
  const QuadraticFit::Terms height = fit.solve();
  return {origin + static_cast<float>(height[0]) * normal, tilted(normal, axis_x, axis_y, height)};
}

BasePatch BaseSurface::patch(Index node) {
  return patches_.get(node, [&] { return make_patch(node); });
}

BasePatch BaseSurface::make_patch(Index node) {
  const Smoothed own = twice(node);
  ConnectedNodes connected;
  std::vector<Vec3f> ring{own.position};
  connected.find(neighbours(), std::array{node}, [&](Index other) {
    const Smoothed at = twice(other);
    const bool near = squared_distance(at.position, own.position) <= ring_ * ring_ &&
                      at.normal.dot(own.normal) > same_side;
    if (near) ring.push_back(at.position);
    return near;
  });
  Vec3f normal = own.normal.isZero(0) ? Vec3f::UnitZ() : own.normal;
  for (int round = 0;; ++round) {
    const Vec3f axis_x = normal.unitOrthogonal(), axis_y = normal.cross(axis_x);
    QuadraticFit fit(ring_);
    for (const Vec3f& position : ring) fit.add(local(own.position, axis_x, axis_y, normal, position), 1);
    const QuadraticFit::Terms height = fit.solve();
    if (round == 1)
      return {own.position,
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

BasePoint BaseSurface::project(Index near, const Vec3f& point) {
  const Index node = nearest(near, point);
  const BasePatch own = patch(node);
  const BasePatch::Local<float> foot = own.foot(point);
  const Vec3f middle = own.place(foot);
  const double reach = blend_over_spacing * spacing();
  std::vector<Index> two_rings{node};
  for (const Index one : neighbours()[node]) {
    two_rings.push_back(one);
    for (const Index two : neighbours()[one]) two_rings.push_back(two);
  }
  sort_unique(two_rings);
  Vec3d position = Vec3d::Zero(), normal = Vec3d::Zero();
  double weights = 0;
  for (const Index other : two_rings) {
    const BasePatch at = patch(other);
    if (!(at.normal.dot(own.normal) > same_side)) continue;
    const double weight = bump_weight(squared_distance(at.position, middle) / (reach * reach));
    if (!(weight > 0)) continue;
    const BasePatch::Local<float> there = at.foot(point);
    position += weight * at.place(there).cast<double>();
    normal += weight * at.normal_at(there).cast<double>();
    weights += weight;
  }
  if (!(weights > 0 && normal.squaredNorm() > 0)) return {middle, own.normal_at(foot), node};
  return {(position / weights).cast<float>(), normal.normalized().cast<float>(), node};
}

}  // namespace burin
