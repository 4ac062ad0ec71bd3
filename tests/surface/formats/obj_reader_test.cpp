#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "surface/mesh_text_file.h"

namespace burin {
namespace {

using test::MeshFile;

std::string obj_message(const std::string& content) { return MeshFile("a.obj", content).message(); }

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ReadObj, KeepsPolygonsInTheFilesOrder) {
  const MeshFile file("a.OBJ",
                      "# five corners, then a quad by negative indices, in two groups\n"
                      "v 0 0 0\r\nv 1 0 0\nv +2 1e0 .5\nv 1 2 0 1.0\nv 0 1 0 0.5 0.5 0.5\nvt 0 0\n"
                      "g one\nf 1/1/1 2//1 3 4 5\ng two\nf -5 -4 -2 -1\n");
  const PolygonMesh mesh = read_mesh(file.path());
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[2], Vec3f(2, 1, 0.5f));
  EXPECT_EQ(mesh.face_sizes, (std::vector<Index>{5, 4}));
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 3, 4, 0, 1, 3, 4}));
  EXPECT_TRUE(mesh.creases.empty());
  EXPECT_EQ(mesh.boundary, BoundaryRule::edges_only);
}

TEST(ReadObj, GathersTagsOfAllGroupsOnce) {
  const MeshFile file("a.obj", three_vertices +
                                   "t crease 2/1/0 0 1 2.5\ng one\nf 1 2 3\nt corner 1/1/0 2 10\n"
                                   "g two\nf 3 2 1\nt interpolateboundary 1/0/0 1\n");
  const PolygonMesh mesh = read_mesh(file.path());
  ASSERT_EQ(mesh.creases.size(), 1u);
  EXPECT_EQ(mesh.creases[0].a, 0u);
  EXPECT_EQ(mesh.creases[0].b, 1u);
  EXPECT_EQ(mesh.creases[0].sharpness, 2.5f);
  ASSERT_EQ(mesh.corners.size(), 1u);
  EXPECT_EQ(mesh.corners[0].vertex, 2u);
  EXPECT_EQ(mesh.corners[0].sharpness, 10.0f);
  EXPECT_EQ(mesh.boundary, BoundaryRule::edges_and_corners);
}

TEST(ReadObj, NamesTheLineThatIsWrong) {
  EXPECT_EQ(obj_message("v 0 0 nan\n"), "a.obj:1: the coordinate 'nan' is not finite");
  EXPECT_EQ(obj_message("\nv 0 0 1e39\n"), "a.obj:2: the coordinate '1e39' is not finite");
  EXPECT_EQ(obj_message("v 1 2\n"), "a.obj:1: a vertex needs three coordinates");
  EXPECT_EQ(obj_message("v 1 2 x3\n"), "a.obj:1: 'x3' is not a coordinate");
  EXPECT_EQ(obj_message("v 1 2 3,5\n"), "a.obj:1: '3,5' is not a coordinate");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2\n"), "a.obj:4: a face of 2 corners");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 a\n"), "a.obj:4: 'a' is not a vertex of a face");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 0\n"), "a.obj:4: '0' is not a vertex of a face");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 4\nf 1 2 3\n"), "a.obj:4: the face names vertex 4 of 3");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 -4\n"), "a.obj:4: the face names vertex -4 of 3 so far");
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 99999999999999999999\n"),
            "a.obj:4: '99999999999999999999' is not a vertex of a face");
}

TEST(ReadObj, ReadsTextureCoordinatesOfCorners) {
  const std::string faces = "f 2/2 3/-1 1/+1/7\nvt 0.5\nf 1/-4/1 2/4 3/3\n";
  const PolygonMesh mesh =
      read_mesh(MeshFile("a.obj", three_vertices + "vt 0 .25\r\nvt 1 0 9\nvt 0.75 1e-1\n" + faces).path());
  EXPECT_EQ(mesh.corner_uv,
            (std::vector<Vec2f>{{1, 0}, {0.75F, 0.1F}, {0, 0.25F}, {0, 0.25F}, {0.5F, 0}, {0.75F, 0.1F}}));
  for (const char* corners : {"f 1/1 2/1 3\n", "f 1//1 2/1 3/1\n", "f 1 2 3\n", "f 1// 2// 3//\n"})
    EXPECT_TRUE(read_mesh(MeshFile("a.obj", three_vertices + "vt 0 0\nf 1/1 2/1 3/1\n" + corners).path())
                    .corner_uv.empty());
}

// The lines are as ZBrush writes them. A mask of ff means free.
TEST(ReadObj, ReadsPolypaintFromComments) {
  const std::string faces = "f 1 2 3\n";
  const PolygonMesh mesh = read_mesh(
      MeshFile("a.obj", three_vertices +
                            "# 64 entries per MRGB line\n#MRGB ff102030\r\n#MRGB 00FFfeFd33000000\n" + faces)
          .path());
  EXPECT_EQ(mesh.paint.colours,
            (std::vector<PaintBytes>{{16, 32, 48, 255}, {255, 254, 253, 255}, {0, 0, 0, 255}}));
  EXPECT_EQ(mesh.paint.masks, (std::vector<float>{1, 0, 0.2F}));
  EXPECT_TRUE(mesh.not_used.empty()) << mesh.not_used;
  const MeshFile free("a.obj", three_vertices + "#MRGB ff102030ff102030ff102030\n" + faces);
  EXPECT_TRUE(read_mesh(free.path()).paint.masks.empty());
}

TEST(ReadObj, PassesOverPolypaintThatIsNotOfAllVertices) {
  for (const char* digits : {"ff102030", "ff102030ff102030ff1020", "ff102030ff102030ff10203g",
                             "ff102030ff102030ff102030ff102030", "-f102030ff102030ff102030", ""}) {
    const MeshFile file("a.obj", three_vertices + "#MRGB " + digits + "\nf 1 2 3\n");
    const PolygonMesh mesh = read_mesh(file.path());
    EXPECT_TRUE(mesh.paint.empty()) << digits;
    EXPECT_EQ(mesh.not_used, "1 line of polypaint") << digits;
  }
}

TEST(ReadObj, TakesColoursBehindCoordinatesBeforePolypaint) {
  const MeshFile file("a.obj",
                      "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n"
                      "#MRGB ff0000ffff0000ffff0000ff\nf 1 2 3\n");
  const PolygonMesh mesh = read_mesh(file.path());
  EXPECT_EQ(mesh.paint.colours, (std::vector<PaintBytes>(3, {255, 0, 0, 255})));
  EXPECT_EQ(mesh.not_used, "1 line of polypaint");
}

TEST(ReadObj, ReadsTextureCoordinatesThatAreNoNumbers) {
  const PolygonMesh mesh = read_mesh(
      MeshFile("a.obj", three_vertices + "vt nan 0\nvt 1 -inf\nvt 1 -1.#IND # no number\nf 1/1 2/2 3/3\n")
          .path());
  ASSERT_EQ(mesh.corner_uv.size(), 3u);
  EXPECT_TRUE(std::isnan(mesh.corner_uv[0].x()));
  EXPECT_TRUE(std::isinf(mesh.corner_uv[1].y()));
  EXPECT_TRUE(std::isnan(mesh.corner_uv[2].y()));
  EXPECT_EQ(obj_message("v 0 0 -1.#IND\n"), "a.obj:1: the coordinate '-1.#IND' is not finite");
}

TEST(ReadObj, NamesTheLineOfWrongTextureCoordinates) {
  EXPECT_EQ(obj_message("vt u 0\n"), "a.obj:1: 'u' is not a coordinate");
  EXPECT_EQ(obj_message("vt\n"), "a.obj:1: texture coordinates without a number");
  const std::string begin = three_vertices + "vt 0 0\n";
  EXPECT_EQ(obj_message(begin + "f 1/1 2/1 3/2\nf 1 2 3\n"),
            "a.obj:5: the face names texture coordinates 2 of 1");
  EXPECT_EQ(obj_message(begin + "f 1/1 2/-2 3/1\n"),
            "a.obj:5: the face names texture coordinates -2 of 1 so far");
  for (const char* corner : {"1/0", "1/x", "1/x/2", "1/1/1/1", "/1", "1/1/x", "1//0"})
    EXPECT_EQ(obj_message(begin + "f " + corner + " 2/1 3/1\n"),
              std::string("a.obj:5: '") + corner + "' is not a vertex of a face");
}

TEST(ReadObj, ReadsFacesOfAnyNumberOfCorners) {
  std::string vertices, face = "f";
  for (int i = 1; i <= 300; ++i) {
    vertices.append("v ").append(std::to_string(i)).append(" 0 0\n");
    face.append(" ").append(std::to_string(i));
  }
  EXPECT_EQ(read_mesh(MeshFile("a.obj", vertices + face).path()).face_sizes, std::vector<Index>{300});
}

TEST(ReadObj, ReadsCornersThatLeaveTheirSlashesBehind) {
  const PolygonMesh mesh = read_mesh(MeshFile("a.obj", three_vertices + "vt 0 1\nf 1/1/ 2/1/ 3/1/\n").path());
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.corner_uv, (std::vector<Vec2f>(3, Vec2f(0, 1))));
  EXPECT_EQ(read_mesh(MeshFile("a.obj", three_vertices + "f 1/ 2// 3\n").path()).face_sizes,
            std::vector<Index>{3});
}

TEST(ReadObj, ReadsWhateverEndsItsLines) {
  const std::string text =
      three_vertices + "# a comment \\\nf 1 2 \\\n  3 # another\nf 3 2 \\\n\\\n1\nf 1 2 4\n";
  EXPECT_EQ(obj_message(text), "a.obj:10: the face names vertex 4 of 3");
  for (const std::string end : {"\r", "\r\n", "\n"}) {
    std::string ended;
    for (const char c : text) c == '\n' ? ended += end : ended += c;
    EXPECT_EQ(obj_message("\xef\xbb\xbf" + ended), "a.obj:10: the face names vertex 4 of 3");
    const std::string good = ended.substr(0, ended.find("f 1 2 4"));
    EXPECT_EQ(read_mesh(MeshFile("a.obj", "\xef\xbb\xbf" + good).path()).face_vertices,
              (std::vector<Index>{0, 1, 2, 2, 1, 0}));
  }
  EXPECT_EQ(obj_message("v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\rv x 0 0"), "a.obj:5: 'x' is not a coordinate");
}

TEST(ReadObj, NamesTheEncodingOfATextInUtf16) {
  EXPECT_EQ(obj_message(std::string("\xff\xfev\0 \0", 6)), "a.obj: is text in UTF-16; save it as UTF-8");
}

TEST(ReadObj, QuotesWordsOfBoundedLength) {
  EXPECT_EQ(obj_message("v 0 0 a\x1b[2J\x07\n"), "a.obj:1: 'a\\x1b[2J\\x07' is not a coordinate");
  EXPECT_EQ(obj_message("v 0 0 " + std::string(100000, 'x') + "\n"),
            "a.obj:1: '" + std::string(40, 'x') + "...' is not a coordinate");
}

TEST(ReadObj, ReadsColoursOfVertices) {
  const std::string tail = "f 1 2 3\n";
  using Colours = std::vector<std::array<std::uint8_t, 4>>;
  const auto colours = [&](const std::string& vertices) {
    return read_mesh(MeshFile("a.obj", vertices + tail).path()).paint.colours;
  };
  EXPECT_EQ(colours("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1.0000001\nv 0 1 0 1 0 1 0\n"),
            (Colours{{255, 128, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}}));
  EXPECT_EQ(colours("v 0 0 0 255 128 0\nv 1 0 0 1 2 3\nv 0 1 0\n"),
            (Colours{{255, 128, 0, 255}, {1, 2, 3, 255}, {0, 0, 0, 0}}));
  EXPECT_EQ(colours("v 0 0 0 1 0.5 0 1\nv 1 0 0 1 0 0 0.2\nv 0 1 0 0 0 1 1\n"),
            (Colours{{255, 128, 0, 255}, {255, 0, 0, 51}, {0, 0, 255, 255}}))
      << "with coverage, since the first is no weight";
  EXPECT_EQ(colours("v 0 0 0 1 9 0 1\nv 1 0 0 255 0 0 0.2\nv 0 1 0 0 0 1 1\n"),
            (Colours{{1, 9, 0, 255}, {255, 0, 0, 51}, {0, 0, 1, 255}}));
  EXPECT_EQ(colours("v 0 0 0 1 0.5 0 1\nv 1 0 0 1 0 0 1\nv 0 1 0 1 0 1 1\n"),
            (Colours{{255, 128, 0, 255}, {255, 0, 0, 255}, {255, 0, 255, 255}}));
  EXPECT_TRUE(colours("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n").empty());
  const PolygonMesh out_of_range =
      read_mesh(MeshFile("a.obj", "v 0 0 0 -3 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n" + tail).path());
  EXPECT_TRUE(out_of_range.paint.empty());
  EXPECT_EQ(out_of_range.not_used, "3 colours out of range");
}

TEST(ReadObj, CountsWhatItMakesNoUseOf) {
  const MeshFile file("a.obj", "mtllib a.mtl\no all\ng one\n" + three_vertices +
                                   "vn 0 0 1\nvn 0 1 0\nusemtl red\ng two\nf 1//1 2//1 3//2\nusemtl blue\n"
                                   "usemtl red\ns off\nl 1 2\nt smooth 0/0/0\nf 3 2 1\n");
  EXPECT_EQ(read_mesh(file.path()).not_used,
            "1 object, 2 groups, 2 normals, 2 materials, 1 line, 1 other tag");
}

TEST(ReadObj, ReadsTagsAsTheShapesOfOpenSubdivHaveThem) {
  const PolygonMesh mesh =
      read_mesh(MeshFile("a.obj", three_vertices +
                                      "f 1 2 3\nf 3 2 1\no x\nt crease 4/2/0 0 1 1 2 2 -3\n"
                                      "t corner 2/1/0 0 2 4\nt hole 1/0/0 1\nt interpolateboundary 1/0/0 0\n"
                                      "t creasemethod 0/0/1 chaikin\n")
                    .path());
  ASSERT_EQ(mesh.creases.size(), 2u);
  EXPECT_EQ(mesh.creases[1].b, 2u);
  EXPECT_EQ(mesh.creases[0].sharpness, 2);
  EXPECT_EQ(mesh.creases[1].sharpness, 0);
  ASSERT_EQ(mesh.corners.size(), 2u);
  EXPECT_EQ(mesh.corners[1].sharpness, 4);
  EXPECT_EQ(mesh.holes, std::vector<Index>{1});
  EXPECT_EQ(mesh.boundary, BoundaryRule::none);
  EXPECT_EQ(mesh.crease_method, CreaseMethod::chaikin);
}

TEST(ReadObj, TakesSharpnessesOfVerticesAsOpenSubdivCountsThem) {
  const auto creases = [](const std::string& tag) {
    return read_mesh(MeshFile("a.obj", three_vertices + "f 1 2 3\n" + tag).path()).creases;
  };
  const std::vector<CreaseEdge> four = creases("t crease 4/4/0 0 1 1 2 2 9 3 9\n");
  ASSERT_EQ(four.size(), 2u);
  EXPECT_EQ(four[0].sharpness, 2);
  EXPECT_EQ(four[1].sharpness, 3);
  EXPECT_EQ(creases("t crease 4/1/0 0 1 1 2 5\n")[1].sharpness, 5);
  EXPECT_EQ(obj_message(three_vertices + "f 1 2 3\nt crease 4/3/0 0 1 1 2 5 5 5\n"),
            "a.obj:5: tag crease: takes one sharpness for all, or one each");
}

TEST(ReadObj, RejectsBrokenTags) {
  const std::string begin = three_vertices + "f 1 2 3\n";
  EXPECT_EQ(obj_message(begin + "t crease 2/1/0 0 3 1\n"),
            "a.obj:5: tag crease: names vertex 3, counted from 0, of 3");
  EXPECT_EQ(obj_message(begin + "t crease 1/1/0 0 1\n"), "a.obj:5: tag crease: takes vertices by pairs");
  EXPECT_EQ(obj_message(begin + "t crease 2/1/0 0 1\n"),
            "a.obj:5: tag: has not the arguments that '2/1/0' announces");
  EXPECT_EQ(obj_message(begin + "t corner 1/1/0 0 nan\n"), "a.obj:5: tag: 'nan' is not a real number");
  EXPECT_EQ(obj_message(begin + "t hole 1/0/0 1\n"), "a.obj:5: tag hole: names face 1, counted from 0, of 1");
  EXPECT_EQ(obj_message(begin + "t hole x\n"),
            "a.obj:5: tag: 'x' is not the number of a tag's arguments, as in 2/1/0");
  EXPECT_EQ(obj_message(begin + "t interpolateboundary 1/0/0 3\n"),
            "a.obj:5: tag interpolateboundary: takes one rule, 0, 1 or 2");
  EXPECT_EQ(obj_message(begin + "t creasemethod 0/0/1 odd\n"),
            "a.obj:5: tag creasemethod: takes one method, normal or chaikin");
}

}  // namespace
}  // namespace burin
