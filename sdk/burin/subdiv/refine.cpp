// Refines a cage uniformly with OpenSubdiv.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/subdiv/refine.h>
#include <burin/subdiv/refined_topology.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

/// The positions of the last level. Keeps the positions of two levels in memory.
std::vector<Vec3f> refined_positions(const PolygonMesh& cage, const TopologyRefiner& refiner) {
  std::vector<Vec3f> coarse = cage.positions, fine;
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    fine.resize(vertex_count(refiner, level));
    subdivide(refiner, level, coarse, fine);
    coarse = std::move(fine);
  }
  return coarse;
}

}  // namespace

SubdivisionScheme natural_scheme(const PolygonMesh& cage) {
  const bool triangles = std::ranges::all_of(cage.face_sizes, [](Index size) { return size == 3; });
  return triangles ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark;
}

std::size_t refined_triangle_count(const PolygonMesh& cage, SubdivisionScheme scheme, int level) {
  const std::size_t corners = cage.face_vertices.size(), faces = cage.face_sizes.size();
  if (level == 0) return corners - 2 * faces;
  if (scheme == SubdivisionScheme::loop) return faces << 2 * level;
  return corners << (2 * level - 1);
}

int level_for_triangles(const PolygonMesh& cage, SubdivisionScheme scheme, std::size_t triangles) {
  for (int level = 0; level <= highest_level; ++level) {
    const std::size_t count = refined_triangle_count(cage, scheme, level);
    if (count > most_triangles) break;
    if (count >= triangles) return level;
  }
  throw Error(fmt::format("no level of at most {} triangles has {}", most_triangles, triangles));
}

TriangleMesh refine(const PolygonMesh& cage, SubdivisionScheme scheme, int level, const Progress& progress) {
  if (level == 0) return triangulate(cage);
  report(progress, "refining the cage", 0);
  const auto refiner = refined_topology(cage, scheme, level);
  report(progress, "refining the cage", 0.5);
  TriangleMesh result;
  parallel_blocks(2, 1, [&](std::size_t half, std::size_t) {
    if (half == 0) result.positions = refined_positions(cage, *refiner);
    if (half == 1) result.triangles = level_triangles(*refiner, level);
  });
  if (!cage.corner_uv.empty()) result.triangle_uv = level_triangle_uv(*refiner, level, cage);
  report(progress, "refining the cage", 1);
  return result;
}

}  // namespace burin
