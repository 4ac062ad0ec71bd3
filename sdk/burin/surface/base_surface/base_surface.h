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

/// A point of the base surface.
struct BasePoint {
  Vec3f position, normal;
  Index node;  ///< the nearest node
};

/// A surface smoothed at the scale of a brush's radius: relief narrower than the radius is removed, curvature
/// wider than the brush is preserved. Each cluster of a coarser level has a node, which is moved twice onto
/// the paraboloid that best fits the surface within 0.55 radii.
///
/// Nodes are computed on demand, a few neighbours at a time. All functions but set_radius() and forget() may
/// be called from several threads at once; the order of calls does not change any value.
class BaseSurface {
 public:
  /// Surface and levels must outlive the object.
  BaseSurface(const Surface& surface, const SurfaceLevels& levels) : surface_(&surface), levels_(&levels) {}

  /// Fewest edges per radius: on a coarser level, and on the surface's own vertices.
  static constexpr double fewest_edges = 9.5, fewest_own_edges = 5;

  /// Selects brushes of this radius, object units, and the coarsest level that has enough edges per radius.
  /// Nodes computed for the same radius are kept. Returns false when even the surface itself is too coarse,
  /// or half of its area lies in triangles longer than two radii, as in models of CAD with dense rims;
  /// then the object must not be used. `fine`: triangles are small where the object will be used, whatever
  /// those elsewhere are.
  bool set_radius(double radius, bool fine = false);

  /// Discards the nodes that depend on vertices which moved, by at most `distance`, object units. The levels
  /// must be updated first.
  void forget(std::span<const Index> moved_vertices, double distance);

  /// A ball; `near` is a node in it, and only nodes connected with that one within the ball count.
  struct Ball {
    Vec3f middle;
    double radius;
    Index near;
  };

  /// Computes the nodes within these balls, on all threads.
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

  /// The point of the base surface nearest to `point`, searched from the node `near`. It is the weighted mean
  /// of the foot points on the paraboloids around, so that it varies smoothly. It lies within two spacings,
  /// or two edges, of a node, however far away `point` is.
  BasePoint project(Index near, const Vec3f& point);

  /// A paraboloid and its weight.
  struct Weighted {
    BasePatch patch;
    double weight = 0;  ///< above 0
  };

  /// The paraboloids whose weighted mean is the base surface at a position near a node; none if the position
  /// is far from all nodes.
  std::vector<Weighted> around(Index node, const Vec3f& position);

 private:
  using Sample = SurfaceSample;

  /// Groups (clusters of the group level) whose values are to be computed.
  struct Missing {
    std::vector<Index> once, twice, patches;
  };
  Missing missing_in(const Ball& ball) const;
  Sample mean(Index cluster);
  Sample once(Index cluster);
  Sample twice(Index node);
  std::vector<Index> ring(Index node) const;
  std::vector<Index> towards(Index node, const Vec3f& point) const;
  std::vector<Index> two_rings(Index node) const;
  void note_width(double width);
  double edge(Index node);

  /// Values of clusters of `level` are computed from the samples of `sample_level` within `reach` of their
  /// origins.
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
  void prepare_around(std::span<const Index> nodes, const Vec3f& position);
  Index nearest(Index near, const Vec3f& point);

  const Surface* surface_;
  const SurfaceLevels* levels_;
  std::size_t level_ = 0;         ///< level of the nodes
  std::size_t coarse_level_ = 0;  ///< level of the clusters smoothed once: the next, if it is fine enough
  std::size_t group_level_ =
      0;  ///< level of the clusters whose nodes are computed together: the next but one
  double reach_ = 0, ring_ = 0;
  /// The largest half width of a group and the longest mean edge of a node seen since the radius was set.
  /// Strokes may have stretched both.
  std::atomic<double> widest_{0};
  OnDemand<Sample> means_;       ///< [node]
  OnDemand<Sample> once_;        ///< [cluster of the coarse level] smoothed once; `up` is its area vector
  OnDemand<Sample> twice_;       ///< [node] smoothed twice; `up` is the unit normal
  OnDemand<BasePatch> patches_;  ///< [node]
};

}  // namespace burin
