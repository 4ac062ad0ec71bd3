#include "support/shapes.h"

#include <burin/surface/topology/surroundings.h>
#include <gtest/gtest.h>

#include <cmath>

namespace burin {
namespace {

/// A grid of squares of these sides in the plane z = 0, each cut along both diagonals' mean: cut along one.
Surface grid(float side_x, float side_y, int count) {
  TriangleMesh mesh;
  for (int row = 0; row < count; ++row)
    for (int column = 0; column < count; ++column)
      mesh.positions.emplace_back(side_x * static_cast<float>(column), side_y * static_cast<float>(row),
                                  0.0f);
  for (int row = 0; row + 1 < count; ++row)
    for (int column = 0; column + 1 < count; ++column) {
      const auto corner = static_cast<Index>(row * count + column), up = corner + static_cast<Index>(count);
      mesh.triangles.push_back({corner, corner + 1, up + 1});
      mesh.triangles.push_back({corner, up + 1, up});
    }
  return make_surface(std::move(mesh));
}

Index vertex_of(const Surface& surface, Index source) {
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex)
    if (surface.source_vertex[vertex] == source) return vertex;
  return no_index;
}

TEST(CellSize, IsTheMeanSquareOfTheEdgesAlongATangent) {
  const Surface surface = grid(0.5f, 0.25f, 5);
  const Index middle = vertex_of(surface, 12);
  ASSERT_EQ(surface.neighbours[middle].size(), 6u);
  // Two of the six edges lie along x, two along y, and two along the diagonal (0.5, 0.25).
  EXPECT_NEAR(cell_size(surface, middle, Vec3f::UnitX()), std::sqrt(2 * 4 * 0.25 / 6), 1e-6);
  EXPECT_NEAR(cell_size(surface, middle, Vec3f::UnitY()), std::sqrt(2 * 4 * 0.0625 / 6), 1e-6);
  EXPECT_EQ(cell_size(surface, middle, Vec3f::UnitZ()), 0);
}

TEST(CellSize, IsTheEdgeOfARegularTriangulation) {
  TriangleMesh mesh;
  mesh.positions.push_back(Vec3f::Zero());
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::acos(-1) / 3;
    mesh.positions.emplace_back(0.3f * static_cast<float>(std::cos(angle)),
                                0.3f * static_cast<float>(std::sin(angle)), 0.0f);
    mesh.triangles.push_back({0, static_cast<Index>(k + 1), static_cast<Index>((k + 1) % 6 + 1)});
  }
  const Surface surface = make_surface(std::move(mesh));
  for (const float angle : {0.0f, 0.4f, 1.3f})
    EXPECT_NEAR(cell_size(surface, vertex_of(surface, 0), {std::cos(angle), std::sin(angle), 0}), 0.3, 1e-6);
}

TEST(MeanCurvature, IsThatOfSpheresCylindersAndPlanes) {
  const Surface sphere = make_surface(test::sphere(4, 0.2, 3));
  double worst = 0;
  for (Index vertex = 0; vertex < sphere.vertex_count(); ++vertex)
    worst = std::max(worst, std::abs(mean_curvature(sphere, vertex) - 1.0));
  EXPECT_LT(worst, 0.02);

  const Surface pipe = make_surface(test::cylinder(0.5, 1, 0.05, 0.3, 4));
  std::size_t inner = 0;
  double squares = 0;
  for (Index vertex = 0; vertex < pipe.vertex_count(); ++vertex) {
    if (std::abs(pipe.positions[vertex].z()) > 0.8f) continue;
    ++inner;
    const double error = mean_curvature(pipe, vertex) - 1;  // half of 1 / 0.5
    squares += error * error;
    ASSERT_LT(std::abs(error), 0.2);
  }
  EXPECT_GT(inner, 1000u);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(inner)), 0.05);

  const Surface flat = grid(1, 1, 5);
  EXPECT_EQ(mean_curvature(flat, vertex_of(flat, 12)), 0);
}

TEST(Umbrella, LeadsToTheMeanOfTheNeighbours) {
  const Surface surface = grid(1, 1, 3);
  const Index middle = vertex_of(surface, 4);
  const Vec3f lifted = umbrella(surface, middle, [&](Index vertex) -> Vec3f {
    return surface.positions[vertex] + (vertex == middle ? Vec3f(0, 0, 0.6f) : Vec3f::Zero());
  });
  EXPECT_NEAR((lifted - Vec3f(0, 0, -0.6f)).norm(), 0, 1e-6);
}

}  // namespace
}  // namespace burin
