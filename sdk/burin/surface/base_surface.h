#pragma once
#include <burin/base/on_demand.h>
#include <burin/surface/base_patch.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_levels.h>

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
/// Nodes are made when they are asked for, by any thread; which ones and in what order makes no difference to
/// any of them. Only set_radius() and forget() must be alone.
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

  /// Makes the nodes within `distance` of the point, of those connected with `near` within, on all threads.
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
  /// paraboloids around, so that places vary smoothly.
  BasePoint project(Index near, const Vec3f& point);

 private:
  /// A cluster brought onto a smooth surface.
  struct Smoothed {
    Vec3f position;
    Vec3f normal;  ///< unit; zero where the area around cancels out
  };

  /// A cluster as a fit counts it: where it stands, and its area vector.
  struct Sample {
    Vec3f position, area;
  };

  const Vec3f& vertex_of(Index node) const { return surface_->positions[levels_->vertex(level_, node)]; }
  ClusterMean mean(Index node);
  Smoothed once(Index cluster);
  Smoothed twice(Index node);
  template <class SampleOf>
  Smoothed smoothed(const Vec3f& origin, const Csr& neighbours, std::span<const Index> starts,
                    const SampleOf& sample_of) const;
  BasePatch make_patch(Index node);
  Index nearest(Index near, const Vec3f& point);

  const Surface* surface_;
  const SurfaceLevels* levels_;
  std::size_t level_ = 0;         ///< of the nodes
  std::size_t coarse_level_ = 0;  ///< of the clusters that are smoothed once: the next, where that is fine enough
  double reach_ = 0, ring_ = 0;
  OnDemand<ClusterMean> means_;  ///< [node]
  OnDemand<Smoothed> once_;      ///< [cluster of the coarse level]
  OnDemand<Smoothed> twice_;     ///< [node]
  OnDemand<BasePatch> patches_;  ///< [node]
};

}  // namespace burin
