#pragma once
#include <burin/subdiv/refine.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

using OpenSubdiv::Far::TopologyLevel;
using OpenSubdiv::Far::TopologyRefiner;

inline constexpr std::size_t most_triangles = std::size_t{1}
                                              << 30;  ///< since OpenSubdiv counts corners in ints
inline constexpr int highest_level = 15;              ///< since OpenSubdiv counts levels in 4 bits

/// The faces, vertices and edges of all levels up to `level` >= 1. For the last level OpenSubdiv keeps only
/// the vertices of faces. Includes the topology of the cage's texture coordinates, if it has any, for
/// level_triangle_uv(). Throws the errors of refine().
std::unique_ptr<TopologyRefiner> refined_topology(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                  int level);

/// Applies the subdivision rules: computes the positions of `level` >= 1 from those of the level before. Both
/// spans have one position per vertex of their level.
void subdivide(const TopologyRefiner& refiner, int level, std::span<const Vec3f> coarse,
               std::span<Vec3f> fine);

/// The faces of `level` >= 1, except holes, as triangles. Quads are split along the diagonal from corner 0 to
/// corner 2 in OpenSubdiv's order. So all diagonals inside a quad of the cage have the same direction and
/// vertices there have valence 6, which is good for the front.
std::vector<Triangle> level_triangles(const TopologyRefiner& refiner, int level);

/// The texture coordinates of the triangles of level_triangles(), by OpenSubdiv's rule
/// FVAR_LINEAR_BOUNDARIES: smooth inside an island, linear along its border. The cage must have texture
/// coordinates.
std::vector<TriangleUv> level_triangle_uv(const TopologyRefiner& refiner, int level, const PolygonMesh& cage);

inline std::size_t vertex_count(const TopologyRefiner& refiner, int level) {
  return static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices());
}

/// The number of corners of each face of a level >= 1, which has quads only or triangles only.
inline std::size_t face_size(const TopologyLevel& level) {
  return static_cast<std::size_t>(level.GetNumFaceVertices() / level.GetNumFaces());
}

}  // namespace burin
