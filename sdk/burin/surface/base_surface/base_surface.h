#pragma once
#include <burin/base/on_demand.h>
#include <burin/surface/base_surface/base_patch.h>
#include <burin/surface/base_surface/surface_levels.h>
#include <burin/surface/base_surface/surface_samples.h>
#include <burin/surface/surface.h>

#include <atomic>
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
/// paraboloid that fits what is within 0.55 radii best.
///
/// Nodes are made, a few neighbours at a time, when they are asked for, by any thread; which ones and in what
/// order makes no difference to any of them. Only set_radius() and forget() must be alone.
class BaseSurface {
 public:
  /// Both must outlive the object.
  BaseSurface(const Surface& surface, const SurfaceLevels& levels) : surface_(&surface), levels_(&levels) {}

  /// Edges that a brush's radius has at least: on a coarser level, and on the surface's own vertices.
  static constexpr double fewest_edges = 9.5, fewest_own_edges = 5;

  /// Goes over to brushes of this radius, object units, on the coarsest level that has edges enough in it.
  /// Nodes made for the same radius stay. False where not even the surface has: it is coarse itself against
  /// the brush, and the object is not to be used.
  bool set_radius(double radius);

  /// Forgets the nodes that vertices have to do with which moved, by at most `distance`, object units, after
  /// the levels followed.
  void forget(std::span<const Index> moved_vertices, double distance);

  /// What is about so near to a point of what is connected with a node there.
  struct Ball {
    Vec3f middle;
    double radius;
    Index near;
  };

  /// Makes the nodes within these, on all threads.
  void prepare(std::span<const Ball> balls);

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
  /// paraboloids around, so that places vary smoothly. Within two spacings, or two edges, of a node, whatever
  /// the point.
  BasePoint project(Index near, const Vec3f& point);

  /// A paraboloid and how much it counts.
  struct Weighted {
    BasePatch patch;
    double weight;  ///< above 0
  };

  /// Those that tell what the base surface is like at a place near to a node, so that it varies smoothly;
  /// none where the place is far from all nodes.
  std::vector<Weighted> around(Index node, const Vec3f& place);

 private:
  using Sample = SurfaceSample;

  /// What is to be made: clusters of the group level.
  struct Missing {
    std::vector<Index> once, twice, patches;
  };
  Missing missing_in(const Ball& ball) const;
  Sample mean(Index cluster);
  Sample once(Index cluster);
  Sample twice(Index node);
  Vec3f normal_around(const Vec3f& origin, const SurfaceSamples& samples) const;
  Sample smoothed(const Sample& origin, const SurfaceSamples& samples) const;
  std::vector<Index> two_rings(Index node) const;
  void note_width(double width);
  double edge(Index node);
  BasePatch fitted(const Sample& origin, double ring, const SurfaceSamples& samples) const;

  /// What values are made of: from the samples of a level within `reach` of their origins.
  struct Making {
    std::size_t level, sample_level;
    double reach;
  };
  template <class Value, class OriginOf, class SampleOf, class Make>
  Value make_group(OnDemand<Value>& values, Index wanted, const Making& making, const OriginOf& origin_of,
                   const SampleOf& sample_of, const Make& make);
  template <class SampleOf>
  SurfaceSamples samples_around(Index group, std::span<const Sample> origins, const Making& making,
                                const SampleOf& sample_of);
  void prepare_around(std::span<const Index> nodes);
  Index nearest(Index near, const Vec3f& point);

  const Surface* surface_;
  const SurfaceLevels* levels_;
  std::size_t level_ = 0;         ///< of the nodes
  std::size_t coarse_level_ = 0;  ///< of the clusters smoothed once: the next, where that is fine enough
  std::size_t group_level_ = 0;   ///< of the clusters whose nodes are made together: the next but one
  double reach_ = 0, ring_ = 0;
  /// Largest half width of a group's nodes, and longest mean edge of one, seen since the radius was set:
  /// strokes may have stretched them.
  std::atomic<double> widest_{0};
  OnDemand<Sample> means_;       ///< [node]
  OnDemand<Sample> once_;        ///< [cluster of the coarse level] where it comes to stand, with its area
  OnDemand<Sample> twice_;       ///< [node] where that comes to stand, with the normal
  OnDemand<BasePatch> patches_;  ///< [node]
};

}  // namespace burin
