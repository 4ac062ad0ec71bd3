#pragma once
#include <burin/base/vector.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_levels.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The base surface around one of its nodes: a paraboloid over the tangent plane there. (x, y) are along
/// axis_x and axis_y = normal x axis_x, object units.
struct BasePatch {
  Vec3f position, normal, axis_x;
  float xx = 0, xy = 0, yy = 0;  ///< second derivatives of the height, 1 / length

  Vec3f axis_y() const { return normal.cross(axis_x); }
  float height(const Vec2f& at) const {
    return (xx * at.x() * at.x() + yy * at.y() * at.y()) / 2 + xy * at.x() * at.y();
  }
  Vec2f slope(const Vec2f& at) const { return {xx * at.x() + xy * at.y(), xy * at.x() + yy * at.y()}; }
  float gauss_curvature() const { return xx * yy - xy * xy; }

  /// The foot of a point on the paraboloid, to second order in its distance from the node.
  Vec2f foot(const Vec3f& point) const;
  Vec3f place(const Vec2f& at) const;
  Vec3f normal_at(const Vec2f& at) const;
};

/// A place on the base surface.
struct BasePoint {
  Vec3f position, normal;
  Index node;  ///< nearest
};

/// A surface as brushes of one radius feel it. Relief that is narrow against the radius is gone, curvature
/// wider than the brush is there: at each cluster of a coarser level stands a node, brought twice onto the
/// paraboloid that fits the clusters within 0.55 radii best.
///
/// Nodes are made when they are asked for; which ones, in what order and on how many threads makes no
/// difference to any of them. One thread at a time, all threads inside.
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

  /// Forgets the nodes that vertices have to do with which moved, by at most `distance`, object units.
  void forget(std::span<const Index> moved_vertices, double distance);

  /// Makes these nodes.
  void prepare(std::span<const Index> nodes);

  /// Makes this node, and some around it while at it, if it has not been made.
  void require(Index node) {
    if (stages_[node] != Stage::fitted) prepare_around(node);
  }

  Index node_count() const { return neighbours().rows(); }
  double spacing() const { return levels_->spacing(level_); }
  Index node_of(Index vertex) const { return levels_->cluster(level_, vertex); }

  /// The nodes as a surface without triangles: positions, normals, Gauss curvature and neighbours, of the
  /// nodes that have been made.
  const Surface& nodes() const { return nodes_; }
  const BasePatch& patch(Index node) const { return patches_[node]; }

  template <class Visit>
  void for_each_vertex(Index node, const Visit& visit) const {
    levels_->for_each_vertex(level_, node, visit);
  }

  Index vertex_count_of(Index node) const {
    Index count = 0;
    for_each_vertex(node, [&](Index) { ++count; });
    return count;
  }

  /// The place on the base surface nearest to a point, found from a node near it: the mean over the
  /// paraboloids around, so that places vary smoothly. Makes nodes as needed.
  BasePoint project(Index near, const Vec3f& point);

 private:
  enum class Stage : std::uint8_t { nothing, averaged, smoothed, smoothed_again, fitted };

  /// Of a cluster.
  struct Mean {
    Vec3f position;  ///< of its vertices, weighted by area
    Vec3f area;      ///< vector: the sum over its share of the triangles, object units^2
  };

  struct LowPassed {
    Vec3f position;
    Vec3f normal;  ///< unit, the mean of the area around; zero where that cancels out
  };

  const Csr& neighbours() const { return levels_->neighbours(level_); }
  std::vector<Index> around(std::span<const Index> nodes, double reach);
  void prepare_around(Index node);
  template <class Make>
  void bring_to(Stage stage, std::span<const Index> nodes, const Make& make);
  const Vec3f& vertex_of(Index node) const { return surface_->positions[levels_->vertex(level_, node)]; }
  Mean mean_of(Index node) const;
  template <class Place>
  LowPassed low_passed(Index node, const Place& place) const;
  BasePatch patch_of(Index node) const;
  void make_patch(Index node);
  Index nearest(Index near, const Vec3f& point);

  const Surface* surface_;
  const SurfaceLevels* levels_;
  std::size_t level_ = 0;
  double reach_ = 0, ring_ = 0;
  std::vector<Stage> stages_;          ///< [node]
  std::vector<bool> around_;           ///< [node] all false between calls of around()
  std::vector<Mean> means_;            ///< [node] from stage averaged on
  std::vector<LowPassed> once_;        ///< [node] from stage smoothed on
  std::vector<LowPassed> low_passed_;  ///< [node] twice, from stage smoothed_again on
  std::vector<BasePatch> patches_;     ///< [node] from stage fitted on
  Surface nodes_;
};

}  // namespace burin
