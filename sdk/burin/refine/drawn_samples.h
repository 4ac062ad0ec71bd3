#pragma once
#include <burin/refine/flat_facet.h>
#include <burin/refine/region_mesh.h>
#include <burin/surface/surface.h>

#include <functional>
#include <span>
#include <vector>

namespace burin {

/// Whether what a vertex of a surface has, such as colours, is about what corners have at these weights.
using IsLikeCorners =
    std::function<bool(Index vertex, const Triangle& corners, const std::array<double, 3>& weights)>;

/// The surface before faces were taken from it, by samples that the faces keep which came in their place: its
/// vertices and the middles of its triangles. So errors do not add up from one collapse to the next.
class DrawnSamples {
 public:
  struct Sample {
    Vec3d at;               ///< object units
    Vec2f uv;               ///< if the surface has them
    Index vertex;           ///< of the surface; no_index for the middle of a triangle
    Index face = no_index;  ///< that keeps it
  };

  /// How far samples may be from faces that keep them, object units; and what else must fit.
  struct Bounds {
    double apart;
    const IsLikeCorners& is_like;
  };

  /// The mesh must outlive the object.
  DrawnSamples(const Surface& surface, const RegionMesh& mesh) : surface_(&surface), mesh_(&mesh) {}

  /// Appends the samples that a face keeps.
  void append_kept(Index face, std::vector<Sample>& samples) const;

  /// Appends a vertex, as a corner of a face.
  void append_vertex(Side side, std::vector<Sample>& samples) const;

  /// What a face is to become.
  struct Draft {
    Index face;
    RegionMesh::Corners corners;
  };

  /// Finds for each sample one of some drafts to keep it; returns whether all are within bounds.
  bool assign(std::span<const Draft> drafts, const Bounds& bounds, std::vector<Sample>& samples) const;

  /// Gives faces the samples that they are to keep, in place of what they had.
  void keep(std::span<const Draft> drafts, std::span<const Sample> samples);

 private:
  bool is_like(const Sample& sample, const RegionMesh::Corners& corners, const std::array<double, 3>& weights,
               const Bounds& bounds) const;
  Triangle numbers_of(const Triangle& corners) const;

  const Surface* surface_;
  const RegionMesh* mesh_;
  std::vector<std::vector<Sample>> kept_;  ///< [face]
};

}  // namespace burin
