#pragma once
#include <burin/base/on_demand.h>
#include <burin/surface/base_patch.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_levels.h>
#include <burin/surface/surface_samples.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A place on the base surface.
struct BasePoint {
  Vec3f position, normal;
  Index node;  ///< nearest
};

/// A surface as brushes of one radius feel it. Relief that is narrow against the radius is gone, curvature
/// wider than the brush is there: at each cluster of a coarser level stands a node, brought twice onto the
/// paraboloid that fits the clusters within 0.55 radii best.
///
/// Nodes are made, a few neighbours at a time, when they are asked for, by any thread; which ones and in what
/// order makes no difference to any of them. Only set_radius() and forget() must be alone.
class BaseSurface {
 public:
  /// Both must outlive the object.
  BaseSurface(const Surface& surface, const SurfaceLevels& levels) : surface_(&surface), levels_(&levels) {}

  /// Edges that a brush's radius has at least: on a coarser level, and on the surface's own vertices.
  static constexpr double fewest_edges = 10.5, fewest_own_edges = 5;

  /// Goes over to brushes of this radius, object units, on the coarsest level that has edges enough in it.
  /// Nodes made for the same radius stay. False where not even the surface has: it is coarse itself against
  /// the brush, and the object is not to be used.
  bool set_radius(double radius);

  /// Forgets the nodes that vertices have to do with which moved, by at most `distance`, object units, after
  /// the levels followed.
  void forget(std::span<const Index> moved_vertices, double distance);

  /// Makes the nodes within about `distance` of the point, of those connected with `near` there, on all
  /// threads.
  void prepare(Index near, const Vec3f& point, double distance);

  Index node_count() const { return neighbours().rows(); }
  const Csr& neighbours() const { return levels_->neighbours(level_); }
  double spacing() const { return levels_->spacing(level_); }
  double scale() const { return surface_->scale; }
  Index node_of(Index vertex) const { return levels_->cluster(level_, vertex); }
  BasePatch patch(Index node);

  template <class Visit>
  void for_each_vertex(Index node, const Visit& visit) const {
    levels_->for_each_vertex(level_, node, visit);
  }

  /// The place on the base surface nearest to a point, found from a node near it: the mean over the
  /// paraboloids around, so that places vary smoothly. Within two spacings of a node, whatever the point.
  BasePoint project(Index near, const Vec3f& point);

 private:
  using Sample = SurfaceSample;

  /// Clusters of the group level, and how far off their means are.
  struct Group {
    Index cluster;
    double squared_distance;
  };

  std::vector<Group> groups_within(Index start, const Vec3f& point, double distance) const;
  Sample mean(Index node);
  Sample once(Index cluster);
  Sample twice(Index node);
  Sample smoothed(const Vec3f& origin, const SurfaceSamples& samples) const;
  BasePatch fitted(const Sample& origin, std::span<const Sample> samples) const;

  /// What values are made of: from the samples of a level within `reach` of their origins.
  struct Making {
    std::size_t level, sample_level;
    double reach;
  };
  template <class Samples, class Value, class OriginOf, class SampleOf, class Make>
  Value make_group(OnDemand<Value>& values, Index wanted, const Making& making, const OriginOf& origin_of,
                   const SampleOf& sample_of, const Make& make);
  template <class SampleOf>
  std::vector<Sample> samples_around(Index group, std::span<const Sample> origins, const Making& making,
                                     const SampleOf& sample_of) const;
  void prepare_around(std::span<const Index> nodes);
  Index nearest(Index near, const Vec3f& point);

  const Surface* surface_;
  const SurfaceLevels* levels_;
  std::size_t level_ = 0;         ///< of the nodes
  std::size_t coarse_level_ = 0;  ///< of the clusters smoothed once: the next, where that is fine enough
  std::size_t group_level_ = 0;   ///< clusters of the next again, whose nodes are made together
  double reach_ = 0, ring_ = 0;
  OnDemand<Sample> means_;       ///< [node]
  OnDemand<Sample> once_;        ///< [cluster of the coarse level] where it comes to stand
  OnDemand<Sample> twice_;       ///< [node] where that comes to stand, with the normal
  OnDemand<BasePatch> patches_;  ///< [node]
};

}  // namespace burin
