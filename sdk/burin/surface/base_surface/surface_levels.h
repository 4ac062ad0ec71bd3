#pragma once
#include <burin/surface/csr.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The mean of a cluster of vertices.
struct ClusterMean {
  Vec3f position;    ///< mean position of its vertices, weighted by area, object units
  Vec3f area;        ///< sum of the area vectors of its share of the triangles, object units^2
  float spread = 0;  ///< mean square of its vertices' distances along one axis of its plane, units^2
};

/// A level coarser than the surface. Its vertices are clusters of vertices of the level below. Clusters are
/// connected on the surface, and their vertices lie within about half a spacing of the middle along the
/// surface; so none reaches across a gap or to the other side of a thin plate.
struct SurfaceLevel {
  /// Edge length of a lattice of equilateral triangles that has as many clusters per area as regions with
  /// several vertices per cluster, object units. In regions where the surface is coarser, clusters are single
  /// vertices.
  double spacing = 0;
  UnsetVector<Index> cluster_of;   ///< [vertex of the level below] its cluster
  Csr members;                     ///< [cluster] vertices of the level below, ascending
  Csr neighbours;                  ///< [cluster] clusters with neighbouring members, ascending
  std::vector<ClusterMean> means;  ///< [cluster]
};

/// The levels of a surface. Level 0 consists of its vertices; the spacing of each further level is about
/// twice that of the level below. Clusters are computed once, from the original positions; vertices that move
/// stay in their clusters and move the clusters' means. Built on all threads; the result does not depend on
/// their number. Const functions may be called from several threads at once.
class SurfaceLevels {
 public:
  /// The surface, which may be a point set, must outlive the object. A surface without area has level 0 only,
  /// with spacing 0.
  explicit SurfaceLevels(const Surface& surface);

  std::size_t size() const { return 1 + coarser_.size(); }
  const Csr& neighbours(std::size_t level) const {
    return level == 0 ? surface_->neighbours : coarser_[level - 1].neighbours;
  }
  std::span<const Index> members(std::size_t level, Index cluster) const {
    return coarser_[level - 1].members[cluster];
  }
  double spacing(std::size_t level) const { return level == 0 ? edge_ : coarser_[level - 1].spacing; }

  /// Half of the surface's area lies in triangles whose longest edge is at least this long, object units; 0
  /// for a point set.
  double longest_edge() const { return longest_edge_; }

  /// The cluster of a vertex of the surface.
  Index cluster(std::size_t level, Index vertex) const { return ancestor(0, vertex, level); }

  /// The cluster of the next coarser level to which a cluster belongs.
  Index parent(std::size_t level, Index cluster) const { return coarser_[level].cluster_of[cluster]; }

  /// The cluster of a coarser level, or of the same level, to which a cluster belongs.
  Index ancestor(std::size_t level, Index cluster, std::size_t coarser) const {
    for (; level < coarser; ++level) cluster = parent(level, cluster);
    return cluster;
  }

  /// The mean of a cluster's vertices at their current positions.
  ClusterMean mean(std::size_t level, Index cluster) const;

  /// Updates the means after these vertices moved.
  void moved(std::span<const Index> vertices);

  /// The first of the clusters of a finer level, or of the same level, that form a cluster.
  Index first_member(std::size_t level, Index cluster, std::size_t finer) const {
    for (; level > finer; --level) cluster = coarser_[level - 1].members[cluster][0];
    return cluster;
  }

  /// Calls visit(vertex) for the vertices of the surface that form a cluster.
  template <class Visit>
  void for_each_vertex(std::size_t level, Index cluster, const Visit& visit) const {
    for_each_member(level, cluster, 0, visit);
  }

  /// Calls visit(member) for the clusters of a finer level, or of the same level, that form a cluster.
  template <class Visit>
  void for_each_member(std::size_t level, Index cluster, std::size_t finer, const Visit& visit) const {
    if (level == finer) return visit(cluster);
    for (const Index member : members(level, cluster)) for_each_member(level - 1, member, finer, visit);
  }

 private:
  std::vector<double> measure_last();
  double area_around(std::size_t level, Index cluster) const;
  ClusterMean mean_of_members(std::size_t level, Index cluster) const;
  void update_means(std::size_t level, std::span<const Index> clusters);

  const Surface* surface_;
  double edge_ = 0;
  double longest_edge_ = 0;
  std::vector<SurfaceLevel> coarser_;
};

}  // namespace burin
