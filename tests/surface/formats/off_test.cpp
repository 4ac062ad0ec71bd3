#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include "surface/mesh_text_file.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

PolygonMesh read(const std::string& content) {
  const test::MeshFile file("a.off", content);
  return read_mesh(file.path());
}

std::string message(const std::string& content) { return test::MeshFile("a.off", content).message(); }

TEST(ReadOff, ReadsWhatProgramsWrite) {
  const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n";
  for (const std::string head : {"OFF\n4 2 0\n", "OFF 4 2 0\n", "off\n4 2 0\n", "nOFF\n3\n4 2 0\n",
                                 "nOFF 3 4 2 0\n", "4 2 5\n", "# by hand\nOFF # kind\n\n4 2\n\n"}) {
    const PolygonMesh mesh = read(head + body);
    EXPECT_EQ(mesh.positions.size(), 4u) << head;
    EXPECT_EQ(mesh.face_sizes, (std::vector<Index>{4, 3})) << head;
    EXPECT_EQ(mesh.not_used, "1 colour of a face") << head;
  }
}

TEST(ReadOff, ReadsWordsInWhateverLines) {
  const PolygonMesh expected = read("OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n");
  for (const std::string text : {"OFF 4 2 5 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3 3 0 1 2",
                                 "OFF4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n",
                                 "OFF\n4\n2\n5\n0 0 0 1 0 0 # two\n1 1 0 0 1 0\n4 0 1 2 3 3 0 1 2",
                                 "4 2 5 0 0\r0 1 0 0 1 1 0 0 1\r0 4 0\r1 2 3\r3 0 1 2",
                                 "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1\n2 3 0.5 0 0\n3 0 1 2 7\n",
                                 "# one\nOFF#\n4 2 5#4\n0 0 0\n1 0 0\n1 1 0\n0 1 0#\n4 0 1 2 3\n\n#\n3 0 1 2",
                                 "OFF\n4 2 5\n0 0 0 9 9 9 255\n1 0 0 9 9 9 255\n1 1 0 9 9 9 255\n0 1 0 9 9 9 "
                                 "255\n4 0 1 2 3\n3 0 1 2\n"}) {
    const PolygonMesh mesh = read(text);
    EXPECT_EQ(mesh.positions, expected.positions) << text;
    EXPECT_EQ(mesh.face_sizes, expected.face_sizes) << text;
    EXPECT_EQ(mesh.face_vertices, expected.face_vertices) << text;
  }
  const PolygonMesh coloured =
      read("COFF 3 1 0 0 0 0 255 1 0 255 1 0 0 0 0 1 128 0 1 0 1 1 1 0 3 0 1 2 0.1 0.2 0.3");
  EXPECT_EQ(coloured.paint.colours,
            (std::vector<std::array<std::uint8_t, 4>>{{255, 1, 0, 255}, {0, 0, 1, 128}, {1, 1, 1, 0}}));
  EXPECT_EQ(coloured.not_used, "1 colour of a face");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0 8 8\n1 0 0\n0 1 0\n3 0 1 2\n").not_used, "2 other numbers of vertices");
}

TEST(ReadOff, ReadsColoursNormalsAndTextureCoordinates) {
  using Colours = std::vector<std::array<std::uint8_t, 4>>;
  const std::string face = "3 0 1 2\n";
  EXPECT_EQ(read("COFF\n3 1 0\n0 0 0 255 1 0 255\n1 0 0 0 0 1 128\n0 1 0 1 1 1 0\n" + face).paint.colours,
            (Colours{{255, 1, 0, 255}, {0, 0, 1, 128}, {1, 1, 1, 0}}));
  EXPECT_EQ(read("COFF\n3 1 0\n0 0 0 1.0 0 0\n1 0 0 0 1.0 0\n0 1 0 0 0 0.5\n" + face).paint.colours,
            (Colours{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 128, 255}}));
  const PolygonMesh all = read(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 255 0 .25\n1 0 0 0 0 1 9 9 9 255 1 0\n0 1 0 0 0 1 9 9 9 255 1 1\n" +
      face);
  EXPECT_EQ(all.corner_uv, (std::vector<Vec2f>{{0, 0.25F}, {1, 0}, {1, 1}}));
  EXPECT_EQ(all.paint.colours, Colours(3, {9, 9, 9, 255}));
  EXPECT_EQ(all.not_used, "3 normals");
}

TEST(ReadOff, NamesTheLineThatIsWrong) {
  EXPECT_EQ(message("OFX\n"), "a.off:1: is not an OFF file: it begins with 'OFX'");
  EXPECT_EQ(message("OFF BINARY\n"), "a.off:1: is a binary OFF file, which is not read");
  EXPECT_EQ(message("4OFF\n1 1 1\n"), "a.off:1: holds points of more than three dimensions");
  EXPECT_EQ(message("OFF\n3\n"), "a.off:2: the numbers of vertices and faces are missing");
  EXPECT_EQ(message("OFF\n3 x 0\n"), "a.off:2: 'x' is not a number of elements");
  EXPECT_EQ(message("OFF\n3 2000000000 0\n"), "a.off:2: is too short for 2000000000 elements");
  EXPECT_EQ(message("OFFx 3\n"), "a.off:1: is not an OFF file: it begins with 'OFFx'");
  EXPECT_EQ(message("OFF 3 1 0\n0 0 0 1 0 0\n0 1 0 3 0\n1 x"),
            "a.off:4: names vertex 'x' of 3, counted from 0");
  EXPECT_EQ(message("OFF 3 1 0 0 0 0 1 0 0 0 # 1"), "a.off:1: a vertex needs three coordinates");
  EXPECT_EQ(message("OFF 3 1 0\n0 0 0 1 0 0\n0 1 0 3 0 1"), "a.off:3: a face of 3 corners names 2 vertices");
  const std::string begin = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  EXPECT_EQ(message(begin), "a.off:4: the file is cut off");
  EXPECT_EQ(message(begin + "0 1\n"), "a.off:5: a vertex needs three coordinates");
  EXPECT_EQ(message(begin + "0 1 inf\n"), "a.off:5: the coordinate 'inf' is not finite");
  EXPECT_EQ(message(begin + "0 1 0\n3 0 1\n"), "a.off:6: a face of 3 corners names 2 vertices");
  EXPECT_EQ(message(begin + "0 1 0\n3 0 1 3\n"), "a.off:6: names vertex '3' of 3, counted from 0");
  EXPECT_EQ(message(begin + "0 1 0\n0\n"), "a.off:6: a face begins with the number of its corners");
  EXPECT_EQ(message(begin + "0 1 0\n2 0 1\n"), "a.off: has no face");
}

// As programs for polyhedra write them, with colours of their own.
TEST(ReadOff, PassesOverPointsAndEdgesAmongTheFaces) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.off";
  write_file_whole(path, [](std::ostream& out) {
    out << "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1 255 0 0\n3 0 1 2\n1 2\n2 1 2\n";
  });
  const PolygonMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.face_sizes, std::vector<Index>{3});
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.not_used, "3 faces of fewer than three corners, 1 colour of a face");
}

TEST(WriteOff, ComesBackBitForBit) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.off";
  const TriangleMesh mesh = test::torus(30, 20);
  VertexPaint paint;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    paint.colours.push_back({static_cast<std::uint8_t>(i), 7, static_cast<std::uint8_t>(i / 2), 255});
  write_mesh(path, mesh, paint);
  const PolygonMesh back = read_mesh(path);
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(triangulate(back).triangles, mesh.triangles);
  EXPECT_EQ(back.paint.colours, paint.colours);
}

}  // namespace
}  // namespace burin
