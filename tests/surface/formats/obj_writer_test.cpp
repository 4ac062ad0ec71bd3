#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

TEST(WriteObj, ComesBackBitForBitWithItsColours) {
  const test::TemporaryFolder folder;
  TriangleMesh mesh = test::torus(30, 20);
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    paint.colours.push_back({static_cast<std::uint8_t>(i), 7, static_cast<std::uint8_t>(200 - i), 255});
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    mesh.triangle_uv.push_back(
        {Vec2f(0.1F, 0.25F), Vec2f(static_cast<float>(i % 50) / 50, 0), Vec2f(1, 0.7F)});
  write_mesh(folder.path() / "a.obj", mesh, paint);
  const PolygonMesh back = read_mesh(folder.path() / "a.obj");
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.paint.colours, paint.colours);
  const TriangleMesh triangles = triangulate(back);
  EXPECT_EQ(triangles.triangles, mesh.triangles);
  EXPECT_EQ(triangles.triangle_uv, mesh.triangle_uv);
  const std::string text = read_file(folder.path() / "a.obj");
  EXPECT_EQ(text.find("vt 0.1 0.25"), text.rfind("vt 0.1 0.25"));
}

TEST(WriteObj, PutsPlacesWhereTheyWere) {
  const test::TemporaryFolder folder;
  write_mesh(folder.path() / "a.obj", {{{0, 0, 0}, {0.5F, 0, 0}, {0, 0.25F, 0}}, {{0, 1, 2}}, {}}, {},
             {448256, 5411840, -8});
  EXPECT_EQ(read_file(folder.path() / "a.obj"),
            "v 448256 5411840 -8\nv 448256.5 5411840 -8\nv 448256 5411840.25 -8\nf 1 2 3\n");
}

}  // namespace
}  // namespace burin
