#include "deform/deform_fixtures.h"

#include <burin/deform/shown/shown_surface.h>
#include <burin/surface/geometry/curvature.h>
#include <burin/surface/geometry/normals.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace burin {
namespace {

constexpr unsigned seed = 3;

/// Some vertices of a surface and random places near them.
struct Moves {
  std::vector<Index> vertices;
  std::vector<Vec3f> places;
};

Moves random_moves(const Surface& surface, std::mt19937& random) {
  std::uniform_real_distribution<float> offset(-0.01f, 0.01f);
  Moves moves;
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    if (random() % 7) continue;
    moves.vertices.push_back(vertex);
    moves.places.push_back(surface.positions[vertex] + Vec3f(offset(random), offset(random), offset(random)));
  }
  return moves;
}

void expect_normals_of_positions(const Surface& surface, const ShownSurface& shown) {
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    ASSERT_EQ(shown.normals()[vertex], vertex_normal(surface, shown.positions(), vertex)) << vertex;
}

TEST(ShownSurface, KeepsNormalsThoseOfThePositions) {
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const Surface surface = test::square(40);
  ShownSurface shown(surface);
  for (int round = 0; round < 3; ++round) {
    const Moves moves = random_moves(surface, random);
    ASSERT_GT(moves.vertices.size(), 100u);
    const auto changed = shown.move(surface, moves.vertices, moves.places);
    EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end()));
    for (const Index vertex : moves.vertices) {
      EXPECT_TRUE(std::binary_search(changed.begin(), changed.end(), vertex));
      for (const Index neighbour : surface.neighbours[vertex])
        EXPECT_TRUE(std::binary_search(changed.begin(), changed.end(), neighbour));
    }
    expect_normals_of_positions(surface, shown);
  }
}

TEST(ShownSurface, ReportsNothingWhereNothingMoves) {
  const Surface surface = test::square(5);
  ShownSurface shown(surface);
  const std::vector<Index> vertices = {3, 7};
  const std::vector<Vec3f> places = {surface.positions[3], surface.positions[7]};
  EXPECT_TRUE(shown.move(surface, vertices, places).empty());
  EXPECT_TRUE(shown.take_displaced(surface).empty());
}

TEST(ShownSurface, CommitsAndGoesBackBitForBit) {
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  Surface surface = test::square(40);
  const Surface original = surface;
  ShownSurface shown(surface);
  const Moves moves = random_moves(surface, random);
  shown.move(surface, moves.vertices, moves.places);
  EXPECT_EQ(surface.positions, original.positions);
  EXPECT_EQ(shown.take_displaced(surface), moves.vertices);
  EXPECT_TRUE(shown.take_displaced(surface).empty()) << "each is told once";

  shown.commit(surface, moves.vertices);
  EXPECT_TRUE(std::equal(surface.positions.begin(), surface.positions.end(), shown.positions().begin()));
  EXPECT_TRUE(std::equal(surface.normals.begin(), surface.normals.end(), shown.normals().begin()));
  EXPECT_NE(surface.normals, original.normals);
  EXPECT_NE(surface.gauss_curvature, original.gauss_curvature);
  for (Index v = 0; v < surface.vertex_count(); ++v)
    ASSERT_EQ(surface.gauss_curvature[v], gauss_curvature(surface, v));

  std::vector<Vec3f> old;
  for (const Index vertex : moves.vertices) old.push_back(original.positions[vertex]);
  shown.move(surface, moves.vertices, old);
  shown.commit(surface, moves.vertices);
  EXPECT_EQ(surface.positions, original.positions);
  EXPECT_EQ(surface.normals, original.normals);
  EXPECT_EQ(surface.gauss_curvature, original.gauss_curvature);
}

}  // namespace
}  // namespace burin
