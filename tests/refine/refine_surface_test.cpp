#include <burin/base/error.h>
#include <burin/surface/topology/euler.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "refined.h"
#include "support/error_of.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

/// How many triangles have each edge, by how often that is.
std::map<int, int> edge_uses(const Surface& surface) {
  std::map<std::pair<Index, Index>, int> uses;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  std::map<int, int> counts;
  for (const auto& [edge, count] : uses) ++counts[count];
  return counts;
}

double area(const Surface& surface) {
  double sum = 0;
  for (const Triangle& t : surface.triangles) {
    const Vec3d a = surface.positions[t[0]].cast<double>();
    sum +=
        (surface.positions[t[1]].cast<double>() - a).cross(surface.positions[t[2]].cast<double>() - a).norm();
  }
  return sum;
}

std::vector<Vec3d> on_sphere(double turn) {
  std::vector<Vec3d> line;
  for (int i = 0; i <= 60; ++i)
    line.push_back(Vec3d(std::cos(turn * i / 60), std::sin(turn * i / 60), 0.3).normalized());
  return line;
}

void expect_good_shapes(const Refinable& refinable, const char* what) {
  SCOPED_TRACE(what);
  const Surface after = patched(refinable.surface, refinable.refine()).surface;
  const Shapes before(refinable.surface, refinable.lengths, true), whole(after, refinable.lengths, true),
      within(after, refinable.lengths, false);
  ASSERT_GT(within.edges.size(), 1000u);
  EXPECT_GE(within.edges.front(), 0.4 * refinable.lengths.edge());
  EXPECT_LE(within.edges.back(), 1.4 * refinable.lengths.edge());
  EXPECT_GE(whole.angles.front(), 0.5 * before.angles.front());
  EXPECT_GE(within.angles.front(), 20);
  EXPECT_GE(within.first_percent(), 30);
}

TEST(RefineSurface, GivesEdgesTheirLengthAndGoodAngles) {
  expect_good_shapes({box({2, 1, 1}), straight({0.2, 0.5, 1}, {1.8, 0.6, 1}), 0.15, 0.01}, "box");
  expect_good_shapes({slivers(), straight({0.1, 0.3, 0}, {0.4, 0.7, 0}), 0.1, 0.01}, "slivers");
  expect_good_shapes({sphere(2, 0.15, 1), on_sphere(1.5), 0.15, 0.01}, "sphere");
}

TEST(RefineSurface, LeavesABoxABox) {
  const Vec3f size(2, 1, 1);
  std::vector<Vec3d> line = straight({1.5, 0.5, 1}, {2, 0.9, 1});
  for (const Vec3d& place : straight({2, 0.9, 1}, {2, 0.8, 0.3})) line.push_back(place);
  const Refinable refinable(box(size), line, 0.15, 0.01);
  const SurfacePatch refined = refinable.refine();
  for (const Vec3f& p : refined.positions) {
    const bool on_face = (p.array() == 0).any() || (p.array() == size.array()).any();
    ASSERT_TRUE(on_face) << p.transpose();
  }
  const Surface after = patched(refinable.surface, refined).surface;
  EXPECT_EQ(euler_characteristic(after), 2);
  EXPECT_EQ(edge_uses(after).size(), 1u);
  EXPECT_NEAR(volume(after), volume(refinable.surface), 1e-6);
  EXPECT_NEAR(area(after), area(refinable.surface), 1e-6);
}

TEST(RefineSurface, ChangesNothingTheSecondTime) {
  const Refinable refinable(sphere(1, 0.15, 2), on_sphere(1.5), 0.15, 0.02);
  const Surface after = patched(refinable.surface, refinable.refine()).surface;
  const std::vector<Index> seeds = refinable.seeds(after);
  const SurfacePatch again = refine_surface(after, refinable.lengths, seeds, 1'000'000).patch;
  EXPECT_TRUE(again.triangles.empty());
  EXPECT_TRUE(again.removed.empty());
}

/// The greatest distance of new vertices from the unit sphere.
double sphere_error(int levels) {
  const Refinable refinable(sphere(levels, 0, 1), on_sphere(1.5), 0.3, 0.02);
  double most = 0;
  for (const Vec3f& p : refinable.refine().positions)
    most = std::max(most, std::abs(p.cast<double>().norm() - 1));
  return most;
}

TEST(RefineSurface, PutsVerticesOnTheSphereThatACoarseMeshStandsFor) {
  // Edges are 0.62, 0.33 and 0.16 long; the middles of triangles are 0.06, 0.017 and 0.0042 off.
  const double coarse = sphere_error(1), finer = sphere_error(2), finest = sphere_error(3);
  EXPECT_LT(coarse, 0.007);
  EXPECT_LT(finer, coarse / 8);
  EXPECT_LT(finest, finer / 8);
}

TEST(RefineSurface, MovesAndChangesNothingElsewhere) {
  const Refinable refinable(sphere(4, 0.15, 3), on_sphere(0.5), 0.1, 0.01);
  const SurfacePatch refined = refinable.refine();
  ASSERT_GT(refined.removed.size(), 20u);
  for (const Index triangle : refined.removed) {
    double nearest = 1e9;
    for (const Index corner : refinable.surface.triangles[triangle])
      nearest = std::min(nearest, refinable.lengths.at(refinable.surface.positions[corner].cast<double>()));
    // Edges are at most 0.12 long, which is long enough 0.2 from the radius.
    EXPECT_LT(nearest, 0.01 + EdgeLength::growth * 0.2);
  }
  EXPECT_EQ(euler_characteristic(patched(refinable.surface, refined).surface), 2);
}

/// Texture coordinates by the two axes along a face of a box, in islands that are this far apart.
TriangleUv face_uv(const std::vector<Vec3f>& positions, const Triangle& t, float island) {
  Eigen::Index axis = 0;
  (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).cwiseAbs().maxCoeff(&axis);
  TriangleUv uv;
  for (std::size_t i = 0; i < 3; ++i)
    uv[i] = {island + positions[t[i]][(axis + 1) % 3], positions[t[i]][(axis + 2) % 3]};
  return uv;
}

TEST(RefineSurface, HalvesTextureCoordinatesWithTheEdgesAndKeepsSeams) {
  // Each of the two triangles of a face is an island.
  constexpr float apart = 5;
  TriangleMesh mesh = box({2, 1, 1});
  for (std::size_t t = 0; t < 12; ++t)
    mesh.triangle_uv.push_back(face_uv(mesh.positions, mesh.triangles[t], t % 2 == 0 ? 0 : apart));
  const Refinable refinable(std::move(mesh), straight({1.5, 0.5, 1}, {1.9, 0.9, 1}), 0.2, 0.02);
  const Surface after = patched(refinable.surface, refinable.refine()).surface;
  ASSERT_EQ(after.triangle_uv.size(), after.triangles.size());
  std::size_t in_second = 0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    const bool second = after.triangle_uv[t][0].x() > 3;
    in_second += second;
    const TriangleUv uv = face_uv(after.positions, after.triangles[t], second ? apart : 0);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_LT((after.triangle_uv[t][i] - uv[i]).norm(), 1e-5F);
  }
  EXPECT_GT(in_second, 100u);
  EXPECT_LT(in_second, after.triangles.size() - 100);
}

TEST(RefineSurface, RefusesMoreTrianglesThanAllowed) {
  const Refinable refinable(box({2, 1, 1}), straight({0.2, 0.5, 1}, {1.8, 0.6, 1}), 0.15, 0.01);
  EXPECT_EQ(error_of([&] { refinable.refine(5000); }),
            "refining the surface would take more than 5000 triangles");
}

TEST(RefineSurface, KeepsTheAreaOfAnySoup) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int crowded = 0;
  for (int i = 0; i < 200; ++i) {
    const Refinable refinable(random_soup(random), straight({-0.3, 0.1, 0}, {0.4, 0.2, 0.1}, 10), 0.3, 0.05);
    const SurfacePatch refined = refinable.refine();
    const Surface after = patched(refinable.surface, refined).surface;
    crowded += edge_uses(refinable.surface).rbegin()->first > 2;
    // Edges that were of one triangle are where there is a border still: no triangle was torn off another.
    EXPECT_EQ(euler_characteristic(after), euler_characteristic(refinable.surface));
    EXPECT_EQ(refined.triangles, refinable.refine().triangles);
    EXPECT_TRUE(
        refine_surface(after, refinable.lengths, refinable.seeds(after), 1'000'000).patch.triangles.empty());
  }
  EXPECT_GT(crowded, 10);
}

}  // namespace
}  // namespace burin::test
