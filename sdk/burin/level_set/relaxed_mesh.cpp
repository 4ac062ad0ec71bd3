// Umbrella smoothing [L. Kobbelt et al., Interactive Multi-Resolution Modeling on Arbitrary Meshes, 1998]
// that comes back to the surface after each round. For a surface of curvature k and edges of mean square e^2
// the umbrella vector reaches k e^2 / 2 inward, and the triangles lie k e^2 / 8 within the surface in the
// mean: a quarter of it.
#include <burin/base/parallel.h>
#include <burin/level_set/relaxed_mesh.h>
#include <burin/remesh/untangle.h>
#include <burin/surface/topology/adjacency.h>

namespace burin {
namespace {

/// From each vertex to the mean of its neighbours.
std::vector<Vec3f> umbrellas(const std::vector<Vec3f>& positions, const Csr& neighbours) {
  std::vector<Vec3f> umbrellas(positions.size());
  parallel_blocks(positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vec3f sum = Vec3f::Zero();
      for (const Index other : neighbours[static_cast<Index>(v)]) sum += positions[other] - positions[v];
      umbrellas[v] =
          sum / static_cast<float>(std::max<std::size_t>(neighbours[static_cast<Index>(v)].size(), 1));
    }
  });
  return umbrellas;
}

Vec3f area_normal(const TriangleMesh& mesh, std::span<const Index> triangles) {
  Vec3f sum = Vec3f::Zero();
  for (const Index number : triangles) {
    const Triangle& triangle = mesh.triangles[number];
    const Vec3f &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
                &c = mesh.positions[triangle[2]];
    sum += (b - a).cross(c - a);
  }
  return sum.stableNormalized();
}

std::vector<Vec3d> in_double(const std::vector<Vec3f>& positions) {
  std::vector<Vec3d> result;
  for (const Vec3f& p : positions) result.push_back(p.cast<double>());
  return result;
}

}  // namespace

void relax(TriangleMesh& mesh, const BringToSurface& bring) {
  constexpr int rounds = 4;
  constexpr float share = 0.5F, left_out = 0.25F;
  const Csr incident = incident_triangles(mesh.positions.size(), mesh.triangles);
  const Csr neighbours = neighbour_vertices(mesh.triangles, incident);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3f> ways = umbrellas(mesh.positions, neighbours);
    for (std::size_t v = 0; v < ways.size(); ++v) mesh.positions[v] += share * ways[v];
    bring(mesh.positions);
  }
  const std::vector<Vec3f> ways = umbrellas(mesh.positions, neighbours);
  std::vector<Vec3f> outward(ways.size());
  for (std::size_t v = 0; v < ways.size(); ++v) {
    const Vec3f normal = area_normal(mesh, incident[static_cast<Index>(v)]);
    outward[v] = -left_out * ways[v].dot(normal) * normal;
  }
  for (std::size_t v = 0; v < ways.size(); ++v) mesh.positions[v] += outward[v];
}

TriangleMesh relaxed_mesh(const GridSurface& surface) {
  TriangleMesh mesh = surface.mesh();
  const std::vector<Vec3d> contour = in_double(mesh.positions);
  const auto bring = [&](std::vector<Vec3f>& positions) { surface.bring(positions); };
  bring(mesh.positions);
  relax(mesh, bring);
  PatchMesh patch{in_double(mesh.positions), std::move(mesh.triangles), {}};
  untangle(patch, contour);
  mesh.triangles = std::move(patch.triangles);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] = patch.positions[v].cast<float>();
  return mesh;
}

}  // namespace burin
