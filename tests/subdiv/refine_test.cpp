#include <burin/base/error.h>
#include <burin/subdiv/refine.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/surface.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "subdiv/cages.h"
#include "support/error_of.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using test::shared_mesh, test::tetrahedron;

using test::catmull_clark, test::loop;

double distance_to_nearest(const Vec3f& point, const std::vector<Vec3f>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3f& other : points) nearest = std::min(nearest, (point - other).cast<double>().squaredNorm());
  return std::sqrt(nearest);
}

/// Every point of either set has one of the other within `tolerance`.
void expect_same_points(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  double farthest = 0;
  for (const Vec3f& point : a) farthest = std::max(farthest, distance_to_nearest(point, b));
  for (const Vec3f& point : b) farthest = std::max(farthest, distance_to_nearest(point, a));
  EXPECT_LE(farthest, tolerance);
}

PolygonMesh square(const std::vector<Index>& sizes, const std::vector<Index>& vertices) {
  PolygonMesh cage;
  cage.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 1}};
  cage.face_sizes = sizes;
  cage.face_vertices = vertices;
  return cage;
}

std::string message(const PolygonMesh& cage, SubdivisionScheme scheme = catmull_clark, int level = 1) {
  return test::error_of([&] { refine(cage, scheme, level); });
}

TEST(Refine, GivesSpotsSecondLevel) {
  const auto cage = shared_mesh("spot_control_mesh.obj"), reference = shared_mesh("spot_quadrangulated.obj");
  if (!cage || !reference) GTEST_SKIP() << "no ../shared/data on this machine";
  expect_same_points(refine(*cage, catmull_clark, 2).positions, reference->positions, 1e-5);
}

/// Pixar's references; their file level N is N + 1 steps.
class PixarReference : public testing::TestWithParam<const char*> {};

TEST_P(PixarReference, HasTheSamePoints) {
  const std::string name = std::string("opensubdiv/catmark_") + GetParam();
  const auto cage = shared_mesh(name + ".obj");
  if (!cage) GTEST_SKIP() << "no ../shared/data on this machine";
  for (int level = 0; level < 3; ++level) {
    SCOPED_TRACE(testing::Message() << "level " << level);
    const auto reference = shared_mesh(name + "_hbr_level" + std::to_string(level) + ".obj");
    expect_same_points(refine(*cage, catmull_clark, level + 1).positions, reference->positions, 2e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Refine, PixarReference,
                         testing::Values("cube", "cube_creases0", "edgecorner", "tent"),
                         [](const auto& test) { return std::string(test.param); });

// C. Loop, Smooth Subdivision Surfaces Based on Triangles (1987). At a vertex of valence 3 beta = 3/16, so it
// keeps 1 - 3 * 3/16 = 7/16 of itself; of the tetrahedron the other corners add up to -p: (7/16 - 3/16) p.
// An edge's point is 3/8 (a + b) + 1/8 (c + d), with c + d = -(a + b): (a + b) / 4.
TEST(Refine, GivesLoopsTetrahedron) {
  const PolygonMesh cage = tetrahedron();
  const TriangleMesh refined = refine(cage, loop, 1);
  std::vector<Vec3f> expected;
  for (const Vec3f& corner : cage.positions) expected.push_back(corner / 4);
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b) expected.push_back((cage.positions[a] + cage.positions[b]) / 4);
  expect_same_points(refined.positions, expected, 1e-7);
  EXPECT_EQ(refined.triangles.size(), 16u);
}

// E. Catmull and J. Clark 1978. Faces' points e_i; an edge's (a + b + F + F') / 4 = (0, 3/4, 3/4); a corner's
// (mean of faces' points + 2 mean of edges' midpoints + (3 - 3) p) / 3 = (1/3 + 4/3) / 3 p = 5/9 p.
TEST(Refine, GivesCatmullAndClarksCube) {
  PolygonMesh cube;
  for (int i = 0; i < 8; ++i)
    cube.positions.emplace_back(i & 1 ? 1.f : -1.f, i & 2 ? 1.f : -1.f, i & 4 ? 1.f : -1.f);
  cube.face_sizes.assign(6, 4);
  cube.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  std::vector<Vec3f> expected;
  for (const Vec3f& corner : cube.positions) expected.push_back(corner * 5 / 9);
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.f, 1.f}) {
      expected.push_back(side * Vec3f::Unit(axis));
      for (const float other : {-1.f, 1.f})
        expected.push_back(0.75f * (side * Vec3f::Unit(axis) + other * Vec3f::Unit((axis + 1) % 3)));
    }
  expect_same_points(refine(cube, catmull_clark, 1).positions, expected, 1e-6);
}

TEST(Refine, KeepsSharpCorners) {
  PolygonMesh cage = tetrahedron();
  cage.corners = {{1, 10}, {2, 1}};
  const auto distance = [&](int corner, int level) {
    return distance_to_nearest(cage.positions[corner], refine(cage, loop, level).positions);
  };
  EXPECT_EQ(distance(1, 3), 0);
  EXPECT_EQ(distance(2, 1), 0);  // sharpness 1 lasts for one level
  EXPECT_GT(distance(2, 2), 0.1);
  EXPECT_GT(distance(3, 1), 0.1);
}

TEST(Refine, KeepsTheOutsideOutside) {
  const PolygonMesh cage = tetrahedron();
  for (const auto scheme : {catmull_clark, loop})
    for (const int level : {0, 1, 3}) {
      const TriangleMesh mesh = refine(cage, scheme, level);
      double volume = 0, cage_volume = 8.0 / 3;
      for (const Triangle& t : mesh.triangles)
        volume += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
      EXPECT_GT(volume, 0.01 * cage_volume);
      EXPECT_LE(volume, 1.0001 * cage_volume);
    }
}

TEST(Refine, GivesVerticesInsideAQuadSixNeighbours) {
  const TriangleMesh mesh = refine(square({4}, {0, 1, 2, 3}), catmull_clark, 4);
  const Surface surface = make_surface(mesh);
  int inner = 0;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    if (surface.incident[v].size() == surface.neighbours[v].size() && !surface.incident[v].empty()) {
      EXPECT_EQ(surface.neighbours[v].size(), 6u);
      ++inner;
    }
  EXPECT_EQ(inner, 15 * 15);
}

TEST(Refine, CountsTrianglesBeforehand) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/penguin_control_mesh.obj");
  for (const PolygonMesh& cage : {read_mesh(path), tetrahedron()}) {
    const SubdivisionScheme scheme = natural_scheme(cage);
    for (int level = 0; level < 4; ++level)
      EXPECT_EQ(refine(cage, scheme, level).triangles.size(), refined_triangle_count(cage, scheme, level));
  }
}

TEST(Refine, FindsTheLevelForACountOfTriangles) {
  const PolygonMesh cage = tetrahedron();
  EXPECT_EQ(level_for_triangles(cage, loop, 1), 0);
  EXPECT_EQ(level_for_triangles(cage, loop, 4), 0);
  EXPECT_EQ(level_for_triangles(cage, loop, 5), 1);
  EXPECT_EQ(level_for_triangles(cage, loop, 16), 1);
  EXPECT_EQ(level_for_triangles(cage, catmull_clark, 3'000'000), 10);
  EXPECT_THROW(level_for_triangles(cage, loop, std::size_t{1} << 40), Error);
  EXPECT_THROW(level_for_triangles(PolygonMesh{}, loop, 1), Error);
}

TEST(Refine, ChoosesLoopForTrianglesOnly) {
  EXPECT_EQ(natural_scheme(tetrahedron()), loop);
  EXPECT_EQ(natural_scheme(square({4}, {0, 1, 2, 3})), catmull_clark);
}

TEST(Refine, SaysWhyACageCannotBeRefined) {
  EXPECT_EQ(message(square({4}, {0, 1, 2, 3}), loop), "Loop subdivision needs a cage of triangles only");
  EXPECT_EQ(message(square({3, 4}, {0, 1, 4, 0, 1, 2, 1})), "face 2 names vertex 2 twice");
  EXPECT_EQ(message(square({4, 4}, {0, 1, 2, 3, 1, 2, 5, 4})),
            "faces 1 and 2 disagree on the outside at the edge between vertices 2 and 3");
  EXPECT_EQ(message(square({4, 4, 3}, {0, 1, 2, 3, 1, 4, 5, 2, 2, 1, 6})),
            "the cage is not a manifold: 3 faces meet at the edge between vertices 2 and 3");
  EXPECT_EQ(message(square({3, 3}, {0, 1, 3, 1, 4, 5})),
            "the cage is not a manifold: 2 separate fans of faces touch at vertex 2, face 1 in one");
  PolygonMesh creased = square({4}, {0, 1, 2, 3});
  creased.creases = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(message(creased), "the crease between vertices 1 and 3 is not on an edge");
  EXPECT_EQ(message(tetrahedron(), loop, 16),
            "level 16 of this cage has 17179869184 triangles; at most 1073741824 can be");
}

TEST(Refine, RefusesPixarsCagesThatAreNotManifolds) {
  for (const char* name :
       {"meshes/opensubdiv/catmark_nonman_edges.obj", "meshes/opensubdiv/catmark_nonman_verts.obj",
        "meshes/nasty/fan3.obj", "meshes/nasty/hourglass_ico.obj", "meshes/nasty/moebius.obj"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, name);
    const PolygonMesh cage = read_mesh(path);
    EXPECT_NE(message(cage), "none") << name;
    EXPECT_EQ(message(cage, catmull_clark, 0), "none") << name;
  }
}

TEST(Refine, RefinesPixarsOtherCages) {
  for (const char* name : {"car", "helmet", "nonquads", "pawn", "pole64", "torus"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("meshes/opensubdiv/catmark_") + name + ".obj");
    const TriangleMesh mesh = refine(read_mesh(path), catmull_clark, 2);
    EXPECT_TRUE(std::ranges::all_of(mesh.positions, [](const Vec3f& p) { return p.allFinite(); })) << name;
  }
}

// Coordinates that are a linear function of the position on a regular grid stay so, up to the border, which
// is linear in itself. Faces of the left and the right half lie in islands apart.
TEST(Refine, CarriesTextureCoordinates) {
  PolygonMesh cage = test::plate(4);
  const auto uv = [](const Vec3f& p, bool right) { return Vec2f(p.y() / 8 + (right ? 0.5F : 0), p.x() / 4); };
  for (Index face = 0; face < 16; ++face)
    for (Index corner = 4 * face; corner < 4 * face + 4; ++corner)
      cage.corner_uv.push_back(uv(cage.positions[cage.face_vertices[corner]], face % 4 >= 2));
  cage.boundary = BoundaryRule::edges_and_corners;
  for (const int level : {0, 1, 3}) {
    const TriangleMesh mesh = refine(cage, catmull_clark, level);
    ASSERT_EQ(mesh.triangle_uv.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Vec3f centre = Vec3f::Zero();
      for (const Index vertex : mesh.triangles[i]) centre += mesh.positions[vertex] / 3;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3f& position = mesh.positions[mesh.triangles[i][corner]];
        EXPECT_LE((mesh.triangle_uv[i][corner] - uv(position, centre.x() > 2)).norm(), 1e-6F);
      }
    }
  }
  cage.corner_uv.clear();
  EXPECT_TRUE(refine(cage, catmull_clark, 1).triangle_uv.empty());
}

// Islands keep their borders, so the area that they cover stays.
TEST(Refine, KeepsTheIslandsOfRealCages) {
  for (const char* name : {"spot_quadrangulated.obj", "spot_triangulated.obj"}) {
    BURIN_SHARED_DATA_OR_SKIP(path, std::string("meshes/") + name);
    const PolygonMesh cage = read_mesh(path);
    ASSERT_FALSE(cage.corner_uv.empty());
    const TriangleMesh mesh = refine(cage, natural_scheme(cage), 1);
    double area = 0, cage_area = 0;
    const auto doubled = [](const TriangleUv& uv) {
      const Vec2f a = uv[1] - uv[0], b = uv[2] - uv[0];
      return static_cast<double>(std::abs(a.x() * b.y() - a.y() * b.x()));
    };
    for (const TriangleUv& uv : mesh.triangle_uv) area += doubled(uv);
    for (const TriangleUv& uv : refine(cage, natural_scheme(cage), 0).triangle_uv) cage_area += doubled(uv);
    EXPECT_NEAR(area, cage_area, 0.01 * cage_area) << name;
  }
}

TEST(Refine, LeavesHolesOutAtEveryLevel) {
  PolygonMesh cage = test::plate(3);
  cage.holes = {4};
  const PolygonMesh whole = test::plate(3);
  for (const int level : {0, 1, 3}) {
    const TriangleMesh mesh = refine(cage, catmull_clark, level), full = refine(whole, catmull_clark, level);
    EXPECT_EQ(mesh.positions, full.positions);
    EXPECT_EQ(9 * mesh.triangles.size(), 8 * full.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
      Vec3f middle = Vec3f::Zero();
      for (const Index vertex : triangle) middle += mesh.positions[vertex] / 3;
      EXPECT_GT((middle - Vec3f(1.5F, 1.5F, 0)).cwiseAbs().maxCoeff(), 0.4F);
    }
  }
}

TEST(Refine, LeavesFacesAtTheBoundaryOutWhereTheRuleSaysSo) {
  PolygonMesh cage = test::plate(4);
  cage.boundary = BoundaryRule::none;
  const TriangleMesh mesh = refine(cage, catmull_clark, 2);
  EXPECT_EQ(mesh.triangles.size(), refined_triangle_count(cage, catmull_clark, 2) / 4);
  for (const Triangle& triangle : mesh.triangles)
    for (const Index vertex : triangle)
      EXPECT_LT((mesh.positions[vertex] - Vec3f(2, 2, 0)).cwiseAbs().maxCoeff(), 1.0001F);
}

TEST(Refine, SmoothsSharpnessAlongCreasesByChaikinsMethod) {
  PolygonMesh cage = test::tetrahedron();
  cage.creases = {{0, 1, 1}, {1, 2, 3}};
  const TriangleMesh uniform = refine(cage, catmull_clark, 3);
  cage.crease_method = CreaseMethod::chaikin;
  EXPECT_NE(refine(cage, catmull_clark, 3).positions, uniform.positions);
  cage.creases = {{0, 1, 2}, {1, 2, 2}, {2, 0, 2}};
  const TriangleMesh equal = refine(cage, catmull_clark, 3);
  cage.crease_method = CreaseMethod::uniform;
  EXPECT_EQ(refine(cage, catmull_clark, 3).positions, equal.positions);
}

}  // namespace
}  // namespace burin
