#pragma once
#include <burin/refine/flat_facet.h>
#include <burin/surface/surface.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace burin {

/// Whether an edge of a surface's triangle is sharp: on a border, where more than two triangles meet or two
/// do not agree on outside, where they meet at more than 35 degrees, or at a seam of texture coordinates.
bool is_sharp(const Surface& surface, Index triangle, std::size_t side);

/// The other triangles that have an edge of a triangle, ascending.
void triangles_beside(const Surface& surface, Index triangle, std::size_t side, std::vector<Index>& beside);

/// A place in a triangle of the surface.
struct FacetPlace {
  Index triangle = no_index;
  std::array<double, 3> weights = {0, 0, 0};  ///< of its corners; their sum is 1, none is negative
  Vec3d flat = Vec3d::Zero();                 ///< on the triangle, object units
};

/// The smooth surface that a coarse one stands for: curved PN triangles [Vlachos, Peters, Boyd and Mitchell,
/// Curved PN Triangles, 2001] with normals of their own on either side of sharp edges, which stay straight.
/// Flat facets stay flat. Triangles are prepared when they are first asked for, in O(1).
class SmoothFacets {
 public:
  /// The surface must outlive the object.
  explicit SmoothFacets(const Surface& surface) : surface_(&surface) {}

  /// The place of the surface nearest to a point, searched from one of its triangles by going on to nearer
  /// ones.
  FacetPlace nearest(Index triangle, const Vec3d& point);

  /// Whether the smooth surface is not the triangle itself.
  bool is_curved(Index triangle) { return facet(triangle).curved; }

  /// The point of the smooth surface there.
  Vec3d smooth(const FacetPlace& place);

 private:
  struct Facet : FlatFacet {
    using FlatFacet::FlatFacet;
    bool curved = false;                         ///< the rest is set
    std::array<Vec3d, 6> edge_points;            ///< control points beside the corners: after and before each
    Vec3d middle = Vec3d::Zero();                ///< control point
    std::array<std::array<Index, 2>, 3> beside;  ///< across each side; no_index for none
  };
  Facet& facet(Index triangle);
  void bend(Index triangle, Facet& facet);
  FacetPlace nearest_on(Index triangle, const Vec3d& point);
  Vec3d normal(Index triangle, std::size_t corner);
  std::vector<std::size_t> fans_around(Index vertex);
  void compute_normals(Index vertex);

  const Surface* surface_;
  std::vector<Facet> facets_;
  std::unordered_map<Index, Index> facet_of_;              ///< triangle: number in facets_
  std::unordered_map<Index, std::vector<Vec3d>> normals_;  ///< vertex: [i] in its i-th triangle
  std::vector<Index> beside_;
};

}  // namespace burin
