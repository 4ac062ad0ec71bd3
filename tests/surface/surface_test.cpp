#include <burin/base/error.h>
#include <burin/base/hash.h>
#include <burin/base/parallel.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/surface.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

std::set<Index> set_of(std::span<const Index> row) { return {row.begin(), row.end()}; }

/// Ascending, each once.
void expect_sorted_rows(const Csr& csr) {
  for (Index row = 0; row < csr.rows(); ++row)
    ASSERT_TRUE(std::ranges::adjacent_find(csr[row], std::greater_equal<>()) == csr[row].end())
        << "row " << row;
}

/// Compares both neighbourhoods with sets that are built triangle by triangle.
void expect_neighbourhoods_of_the_triangles(const Surface& surface) {
  std::vector<std::set<Index>> neighbours(surface.vertex_count()), incident(surface.vertex_count());
  for (Index i = 0; i < surface.triangles.size(); ++i)
    for (const Index vertex : surface.triangles[i]) {
      incident[vertex].insert(i);
      for (const Index other : surface.triangles[i])
        if (other != vertex) neighbours[vertex].insert(other);
    }
  expect_sorted_rows(surface.neighbours);
  expect_sorted_rows(surface.incident);
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    ASSERT_EQ(set_of(surface.neighbours[v]), neighbours[v]) << "vertex " << v;
    ASSERT_EQ(set_of(surface.incident[v]), incident[v]) << "vertex " << v;
  }
}

/// The triangles in the source's vertices, each turned to begin with its lowest, sorted.
std::vector<Triangle> canonical(std::vector<Triangle> triangles, const std::vector<Index>* source = nullptr) {
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  for (Triangle& t : triangles) {
    if (source)
      for (Index& vertex : t) vertex = (*source)[vertex];
    std::ranges::rotate(t, std::ranges::min_element(t));
  }
  std::ranges::sort(triangles);
  return triangles;
}

void expect_invariants(const TriangleMesh& mesh) {
  const Surface surface = make_surface(mesh);
  std::vector<Index> source = surface.source_vertex;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    ASSERT_EQ(surface.positions[v], mesh.positions[source[v]]);
  EXPECT_EQ(canonical(surface.triangles, &source), canonical(mesh.triangles));
  std::ranges::sort(source);
  for (Index v = 0; v < mesh.positions.size(); ++v) ASSERT_EQ(source[v], v);
  ASSERT_EQ(surface.normals.size(), mesh.positions.size());
  for (const Vec3f& normal : surface.normals) ASSERT_NEAR(normal.norm(), 1, 1e-6);
  expect_neighbourhoods_of_the_triangles(surface);
}

class NastyFile : public testing::TestWithParam<const char*> {};

TEST_P(NastyFile, MakesASoundSurface) {
  BURIN_SHARED_DATA_OR_SKIP(path, std::string("meshes/") + GetParam());
  expect_invariants(triangulate(read_mesh(path)));
}

INSTANTIATE_TEST_SUITE_P(Surface, NastyFile,
                         testing::Values("nasty/capsule.obj", "nasty/dragon_vrip_res3.ply", "nasty/fan3.obj",
                                         "nasty/hourglass_ico.obj", "nasty/moebius.obj",
                                         "nasty/not_convex.obj", "nasty/soup.stl",
                                         "opensubdiv/catmark_nonman_edges.obj",
                                         "opensubdiv/catmark_nonman_verts.obj", "spot_control_mesh.obj"));

TEST(MakeSurface, LeavesOutTrianglesThatNameAVertexTwice) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 1}, {0, 1, 2}, {3, 3, 3}}};
  const Surface surface = make_surface(mesh);
  EXPECT_EQ(surface.triangles.size(), 1u);
  EXPECT_EQ(surface.vertex_count(), 4u);
  expect_invariants(mesh);
}

TEST(MakeSurface, TakesDuplicateAndFlatTriangles) {
  expect_invariants(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {0, 1, 3}}});
}

TEST(MakeSurface, TakesCoordinatesOfAnySize) {
  constexpr float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  expect_invariants({{{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, huge}}, {{0, 1, 2}}});
  expect_invariants({{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}, {{0, 1, 2}}});
}

TEST(MakeSurface, RefusesWhatIsNoSurface) {
  EXPECT_THROW(make_surface({}), Error);
  EXPECT_THROW(make_surface({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}, {0, 0, 1}}}), Error);
  EXPECT_THROW(make_surface({{{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}}, {{0, 1, 2}}}), Error);
  EXPECT_THROW(make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}), ContractError);
}

TriangleMesh shuffled(const TriangleMesh& mesh) {
  std::vector<Index> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), Index{0});
  std::mt19937 generator(7);
  std::ranges::shuffle(place, generator);
  TriangleMesh result = mesh;
  for (Index v = 0; v < place.size(); ++v) result.positions[place[v]] = mesh.positions[v];
  for (Triangle& triangle : result.triangles)
    for (Index& vertex : triangle) vertex = place[vertex];
  std::ranges::shuffle(result.triangles, generator);
  return result;
}

double mean_index_distance(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      sum += std::abs(static_cast<double>(t[i]) - static_cast<double>(t[(i + 1) % 3]));
  return sum / (3.0 * static_cast<double>(triangles.size()));
}

// The mean index distance of n shuffled vertices is n / 3. Most edges along a Hilbert curve span at most a
// few hundred.
TEST(MakeSurface, PutsNeighboursNearEachOther) {
  const TriangleMesh mesh = shuffled(test::torus(500, 200));
  EXPECT_GT(mean_index_distance(mesh.triangles), 0.3 * 100000);
  const Surface surface = make_surface(mesh);
  const double distance = mean_index_distance(surface.triangles);
  RecordProperty("mean_index_distance", std::to_string(distance));
  EXPECT_LT(distance, 1000);
  for (Index i = 1; i < surface.triangles.size(); ++i)
    ASSERT_LE(std::ranges::min(surface.triangles[i - 1]), std::ranges::min(surface.triangles[i]));
}

template <class Values>
std::uint64_t hash_of(const Values& values) {
  return hash_bytes(values.data(), values.size() * sizeof(values[0]));
}

std::vector<std::uint64_t> hashes(const Surface& s) {
  return {hash_of(s.positions),          hash_of(s.normals),          hash_of(s.triangles),
          hash_of(s.neighbours.offsets), hash_of(s.neighbours.items), hash_of(s.incident.offsets),
          hash_of(s.incident.items),     hash_of(s.source_vertex)};
}

TEST(MakeSurface, GivesTheSameBitsOnAnyNumberOfThreads) {
  const TriangleMesh mesh = shuffled(test::torus(300, 150));
  const auto on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return hashes(make_surface(mesh));
  };
  EXPECT_EQ(on(1), on(2));
}

TEST(MakeSurface, ReportsItsProgressInOrder) {
  std::vector<std::string> stages;
  make_surface(test::torus(8, 8), [&](std::string_view stage, double done) {
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  });
  EXPECT_EQ(stages,
            (std::vector<std::string>{"sorting the surface", "connecting the surface", "computing normals"}));
}

TEST(MakeSurface, MeasuresTheDiagonal) {
  EXPECT_DOUBLE_EQ(make_surface({{{0, 0, 0}, {3, 0, 0}, {3, 4, 12}}, {{0, 1, 2}}}).scale, 13);
}

}  // namespace
}  // namespace burin
