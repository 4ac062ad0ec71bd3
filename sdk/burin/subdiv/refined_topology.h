#pragma once
#include <burin/subdiv/refine.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <span>
#include <vector>

namespace burin {

using OpenSubdiv::Far::TopologyLevel;
using OpenSubdiv::Far::TopologyRefiner;

inline constexpr std::size_t most_triangles = std::size_t{1} << 30;  ///< OpenSubdiv counts corners in ints
inline constexpr int highest_level = 15;                             ///< OpenSubdiv counts levels in 4 bits

/// The faces, vertices and edges of all levels up to `level` >= 1; of the last one OpenSubdiv keeps what its
/// faces are made of only. With the cage's texture coordinates where it has them, for level_triangle_uv().
/// Throws Error as refine().
std::unique_ptr<TopologyRefiner> refined_topology(const PolygonMesh& cage, SubdivisionScheme scheme,
                                                  int level);

/// Where the subdivision rules put the vertices of `level` >= 1, given those of the level before it: one
/// position for each vertex on either side.
void subdivide(const TopologyRefiner& refiner, int level, std::span<const Vec3f> coarse,
               std::span<Vec3f> fine);

/// The faces of `level` >= 1 but for holes as triangles: quads along the diagonal from corner 0 to corner 2
/// in OpenSubdiv's order. All diagonals inside a quad of the cage then run the same way, so that vertices
/// there have valence 6, as they should for the front.
std::vector<Triangle> level_triangles(const TopologyRefiner& refiner, int level);

/// Texture coordinates of the level's triangles, as level_triangles() gives them, by OpenSubdiv's rule
/// FVAR_LINEAR_BOUNDARIES: smooth inside an island, linear along its border. The cage must have them.
std::vector<TriangleUv> level_triangle_uv(const TopologyRefiner& refiner, int level, const PolygonMesh& cage);

inline std::size_t vertex_count(const TopologyRefiner& refiner, int level) {
  return static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices());
}

/// Corners of each face of a level >= 1: it holds quads only, or triangles only.
inline std::size_t face_size(const TopologyLevel& level) {
  return static_cast<std::size_t>(level.GetNumFaceVertices() / level.GetNumFaces());
}

}  // namespace burin
