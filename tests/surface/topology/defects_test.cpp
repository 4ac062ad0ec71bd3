#include <burin/surface/mesh_file.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

/// The defects of a file of ../shared/data, counted by other means.
struct Known {
  const char* name;
  MeshDefects defects;
};

class FileDefects : public testing::TestWithParam<Known> {};

TEST_P(FileDefects, AreCounted) {
  const auto& [name, expected] = GetParam();
  BURIN_SHARED_DATA_OR_SKIP(path, std::string("meshes/") + name);
  const MeshDefects found = find_defects(triangulate(read_mesh(path)));
  EXPECT_EQ(found.non_manifold_edges, expected.non_manifold_edges);
  EXPECT_EQ(found.non_manifold_vertices, expected.non_manifold_vertices);
  EXPECT_EQ(found.flipped_edges, expected.flipped_edges);
  EXPECT_EQ(found.degenerate_triangles, expected.degenerate_triangles);
  EXPECT_EQ(found.duplicate_triangles, expected.duplicate_triangles);
  EXPECT_EQ(found.duplicate_positions, expected.duplicate_positions);
  EXPECT_EQ(found.unreferenced_vertices, expected.unreferenced_vertices);
}

INSTANTIATE_TEST_SUITE_P(
    Defects, FileDefects,
    testing::Values(Known{"nasty/capsule.obj", {.degenerate_triangles = 200, .duplicate_positions = 250}},
                    Known{"nasty/dragon_vrip_res3.ply",
                          {.non_manifold_edges = 2094,
                           .non_manifold_vertices = 5,
                           .duplicate_triangles = 1254,
                           .unreferenced_vertices = 16}},
                    Known{"nasty/fan3.obj", {.non_manifold_edges = 1}},
                    Known{"nasty/hourglass_ico.obj", {.non_manifold_vertices = 1}},
                    Known{"nasty/moebius.obj", {.flipped_edges = 4}},
                    Known{"nasty/not_convex.obj", {.duplicate_positions = 244}}, Known{"nasty/soup.stl", {}},
                    Known{"dragon_vrip.ply", {.degenerate_triangles = 108, .duplicate_positions = 2100}},
                    Known{"stanford-bunny.obj", {.unreferenced_vertices = 1113}},
                    Known{"opensubdiv/catmark_nonman_verts.obj",
                          {.non_manifold_vertices = 4, .unreferenced_vertices = 1}},
                    Known{"spot_triangulated.obj", {}}));

TEST(Defects, OfATorusAreNone) {
  const MeshDefects defects = find_defects(test::torus(12, 8));
  EXPECT_FALSE(defects.any());
  EXPECT_EQ(defects.text(), "");
}

TEST(Defects, AreNamed) {
  TriangleMesh mesh = test::torus(12, 8);
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.push_back({3, 3, 4});
  mesh.positions.push_back(mesh.positions[5]);
  const MeshDefects defects = find_defects(mesh);
  EXPECT_TRUE(defects.any());
  EXPECT_EQ(defects.text(),
            "3 non-manifold edges, 1 degenerate triangle, 1 duplicate triangle, 1 duplicate position, "
            "1 unreferenced vertex");
}

TEST(Defects, CountsTheEdgesOfATurnedTriangle) {
  TriangleMesh mesh = test::torus(12, 8);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  EXPECT_EQ(find_defects(mesh).text(), "3 edges between flipped triangles");
}

}  // namespace
}  // namespace burin
