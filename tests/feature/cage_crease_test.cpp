// Semi-sharp creases of subdivision cages after refinement, against the refined edges of the creases.
#include <burin/feature/snap.h>
#include <burin/subdiv/refine.h>
#include <burin/subdiv/refined_creases.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/source_numbers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "feature/known_lines.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

/// A crease of a cage on the mesh of a level.
struct RefinedCrease {
  TriangleMesh mesh;
  std::vector<Vec3d> line;                    ///< the vertices of the crease in turn, from any one on
  double edge = 0;                            ///< mean length along it
  std::vector<std::array<Index, 2>> creases;  ///< of the mesh
};

/// The edges of `cage` in one connected set of creases, that of its first crease.
std::vector<std::array<Index, 2>> first_crease(const PolygonMesh& cage) {
  std::vector<std::array<Index, 2>> edges, left;
  for (const CreaseEdge& crease : cage.creases) left.push_back({crease.a, crease.b});
  std::set<Index> reached = {left.front()[0]};
  for (bool grows = true; grows;) {
    grows = false;
    for (auto edge = left.begin(); edge != left.end();) {
      if (!reached.contains((*edge)[0]) && !reached.contains((*edge)[1])) {
        ++edge;
        continue;
      }
      reached.insert(edge->begin(), edge->end());
      edges.push_back(*edge);
      edge = left.erase(edge);
      grows = true;
    }
  }
  return edges;
}

/// Follows edges around a ring.
std::vector<Vec3d> ring_of(const std::vector<std::array<Index, 2>>& edges,
                           const std::vector<Vec3f>& positions) {
  std::map<Index, std::vector<Index>> next;
  for (const auto& [a, b] : edges) next[a].push_back(b), next[b].push_back(a);
  std::vector<Vec3d> ring;
  Index before = no_index, at = edges.front()[0];
  do {
    ring.push_back(positions[at].cast<double>());
    const Index onward = next[at][0] == before ? next[at].at(1) : next[at][0];
    before = at;
    at = onward;
  } while (at != edges.front()[0]);
  return ring;
}

RefinedCrease refined(PolygonMesh cage, float sharpness, int level) {
  for (CreaseEdge& crease : cage.creases) crease.sharpness = sharpness;
  constexpr auto scheme = SubdivisionScheme::catmull_clark;
  RefinedCrease result{refine(cage, scheme, level), {}, 0, refined_creases(cage, scheme, level)};
  PolygonMesh with_first = cage;
  std::erase_if(with_first.creases, [first = first_crease(cage)](const CreaseEdge& crease) {
    return std::ranges::find(first, std::array{crease.a, crease.b}) == first.end();
  });
  result.line = ring_of(refined_creases(with_first, scheme, level), result.mesh.positions);
  for (std::size_t i = 0; i < result.line.size(); ++i)
    result.edge += (result.line[(i + 1) % result.line.size()] - result.line[i]).norm();
  result.edge /= static_cast<double>(result.line.size());
  return result;
}

double distance_from(const std::vector<Vec3d>& ring, const Vec3d& x) {
  double least = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3d& from = ring[i];
    const Vec3d way = ring[(i + 1) % ring.size()] - from;
    const double share = std::clamp((x - from).dot(way) / way.squaredNorm(), 0., 1.);
    least = std::min(least, (x - from - share * way).norm());
  }
  return least;
}

/// A pen along three quarters of a crease that swings beside it.
std::vector<Vec3d> pen_beside(const RefinedCrease& crease) {
  std::vector<Vec3d> pen;
  const Vec3d beside = 3 * crease.edge * Vec3d(0.3, 0.9, 0.2).normalized();
  for (std::size_t i = 0; i < crease.line.size() * 3 / 4; i += 2)
    pen.push_back(crease.line[i] + (0.7 + 0.3 * std::sin(static_cast<double>(i) / 9)) * beside);
  return pen;
}

/// Distances of what the first crease of a cage is found as, with creases of this sharpness, after `level`
/// refinements, in edges, ascending.
std::vector<double> errors_at(const PolygonMesh& cage, float sharpness, int level, FeatureKind kind) {
  const RefinedCrease crease = refined(cage, sharpness, level);
  SnapScene scene(crease.mesh);
  const std::vector<Index> number = numbers_of_source(scene.surface);
  std::vector<std::array<Index, 2>> creases;
  for (const auto& [a, b] : crease.creases)
    creases.push_back({std::min(number[a], number[b]), std::max(number[a], number[b])});
  std::ranges::sort(creases);
  const SnapResult result =
      scene.snap(pen_beside(crease), {.kind = kind, .creases = creases}, {.radius = 10 * crease.edge});
  auto errors =
      distances(result, [&](const Vec3d& x) { return distance_from(crease.line, x) / crease.edge; });
  std::cout << "level " << level << ", sharpness " << sharpness << ": share " << result.snapped_share
            << ", median " << quantile(errors, 0.5) << ", p95 " << quantile(errors, 0.95) << " edges\n";
  EXPECT_GT(result.snapped_share, 0.95);
  return errors;
}

/// The crests of the surface, which are near the cage's lines where these are sharp.
void expect_crests_near(const PolygonMesh& cage, int level, FeatureKind kind) {
  for (const float sharpness : {1.F, 2.F, 3.F, 4.F, 5.F}) {
    const auto errors = errors_at(cage, sharpness, level, kind);
    if (sharpness > 1) EXPECT_LT(quantile(errors, 0.5), 0.25) << "sharpness " << sharpness;
  }
}

/// The cage's lines themselves.
void expect_creases_found(const PolygonMesh& cage, int level) {
  for (const float sharpness : {1.F, 2.F, 3.F, 4.F, 5.F})
    EXPECT_LT(quantile(errors_at(cage, sharpness, level, FeatureKind::crease), 0.95), 1e-4);
}

PolygonMesh cube_with_a_crease(const std::string& path) {
  PolygonMesh cube = read_mesh(path);
  for (std::size_t i = 0; i < 4; ++i)
    cube.creases.push_back({cube.face_vertices[i], cube.face_vertices[(i + 1) % 4], 1});
  return cube;
}

TEST(CageCrease, IsFoundOnARingOfAPawn) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/opensubdiv/catmark_pawn.obj");
  expect_crests_near(read_mesh(path), 3, FeatureKind::valley);
  expect_creases_found(read_mesh(path), 3);
}

TEST(CageCrease, IsFoundAroundTheFaceOfACube) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/opensubdiv/catmark_cube.obj");
  expect_crests_near(cube_with_a_crease(path), 4, FeatureKind::ridge);
  expect_creases_found(cube_with_a_crease(path), 4);
  expect_creases_found(cube_with_a_crease(path), 6);
}

}  // namespace
}  // namespace burin::test
