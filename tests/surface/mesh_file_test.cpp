#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

/// A file of this content in a folder of its own.
class File {
 public:
  File(const std::string& name, const std::string& content) : path_(folder_.path() / name) {
    write_file_whole(path_, [&](std::ostream& out) { out << content; });
  }
  const std::filesystem::path& path() const { return path_; }
  /// What read_mesh says about it, without the folder.
  std::string message() const {
    try {
      read_mesh(path_);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "no error";
  }

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path path_;
};

std::string obj_message(const std::string& content) { return File("a.obj", content).message(); }
std::string ply_message(const std::string& content) { return File("a.ply", content).message(); }

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string ply_header(int vertices, int faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST(ReadObj, KeepsPolygonsInTheFilesOrder) {
  const File file("a.OBJ",
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
  const File file("a.obj", three_vertices +
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
      read_mesh(File("a.obj", three_vertices + "vt 0 .25\r\nvt 1 0 9\nvt 0.75 1e-1\n" + faces).path());
  EXPECT_EQ(mesh.corner_uv,
            (std::vector<Vec2f>{{1, 0}, {0.75F, 0.1F}, {0, 0.25F}, {0, 0.25F}, {0.5F, 0}, {0.75F, 0.1F}}));
  for (const char* corners : {"f 1/1 2/1 3\n", "f 1//1 2/1 3/1\n", "f 1 2 3\n", "f 1// 2// 3//\n"})
    EXPECT_TRUE(read_mesh(File("a.obj", three_vertices + "vt 0 0\nf 1/1 2/1 3/1\n" + corners).path())
                    .corner_uv.empty());
}

TEST(ReadObj, ReadsTextureCoordinatesThatAreNoNumbers) {
  const PolygonMesh mesh =
      read_mesh(File("a.obj", three_vertices + "vt nan 0\nvt 1 -inf\nf 1/1 2/2 3/1\n").path());
  ASSERT_EQ(mesh.corner_uv.size(), 3u);
  EXPECT_TRUE(std::isnan(mesh.corner_uv[0].x()));
  EXPECT_TRUE(std::isinf(mesh.corner_uv[1].y()));
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
  EXPECT_EQ(read_mesh(File("a.obj", vertices + face).path()).face_sizes, std::vector<Index>{300});
}

TEST(ReadObj, ReadsCornersThatLeaveTheirSlashesBehind) {
  const PolygonMesh mesh = read_mesh(File("a.obj", three_vertices + "vt 0 1\nf 1/1/ 2/1/ 3/1/\n").path());
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.corner_uv, (std::vector<Vec2f>(3, Vec2f(0, 1))));
  EXPECT_EQ(read_mesh(File("a.obj", three_vertices + "f 1/ 2// 3\n").path()).face_sizes,
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
    EXPECT_EQ(read_mesh(File("a.obj", "\xef\xbb\xbf" + good).path()).face_vertices,
              (std::vector<Index>{0, 1, 2, 2, 1, 0}));
  }
  EXPECT_EQ(obj_message("v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\rv x 0 0"), "a.obj:5: 'x' is not a coordinate");
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
    return read_mesh(File("a.obj", vertices + tail).path()).paint.colours;
  };
  EXPECT_EQ(colours("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1.0000001\nv 0 1 0 1 0 1 0\n"),
            (Colours{{255, 128, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}}));
  EXPECT_EQ(colours("v 0 0 0 255 128 0\nv 1 0 0 1 2 3\nv 0 1 0\n"),
            (Colours{{255, 128, 0, 255}, {1, 2, 3, 255}, {0, 0, 0, 0}}));
  EXPECT_TRUE(colours("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n").empty());
  const PolygonMesh out_of_range =
      read_mesh(File("a.obj", "v 0 0 0 -3 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n" + tail).path());
  EXPECT_TRUE(out_of_range.paint.empty());
  EXPECT_EQ(out_of_range.not_used, "3 colours out of range");
}

TEST(ReadObj, CountsWhatItMakesNoUseOf) {
  const File file("a.obj", "mtllib a.mtl\no all\ng one\n" + three_vertices +
                               "vn 0 0 1\nvn 0 1 0\nusemtl red\ng two\nf 1//1 2//1 3//2\nusemtl blue\n"
                               "usemtl red\ns off\nl 1 2\nt smooth 0/0/0\nf 3 2 1\n");
  EXPECT_EQ(read_mesh(file.path()).not_used,
            "1 object, 2 groups, 2 normals, 2 materials, 1 line, 1 other tag");
}

TEST(ReadObj, ReadsTagsAsTheShapesOfOpenSubdivHaveThem) {
  const PolygonMesh mesh = read_mesh(
      File("a.obj", three_vertices + "f 1 2 3\nf 3 2 1\no x\nt crease 4/2/0 0 1 1 2 2 -3\n"
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

TEST(ReadMesh, RejectsFilesThatAreNotMeshes) {
  const std::filesystem::path missing = "/nowhere/at/all.obj";
  try {
    read_mesh(missing);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/at/all.obj: No such file or directory");
  }
  EXPECT_EQ(obj_message(""), "a.obj: is empty");
  EXPECT_EQ(obj_message(three_vertices), "a.obj: has no face");
  EXPECT_EQ(File("a.xyz", "1 2 3").message(),
            "a.xyz: '.xyz' is not a mesh format; .obj, .ply, .stl, .off, .gltf and .glb are");
  EXPECT_NE(ply_message("ply\nrubbish\n"), "no error");
  EXPECT_EQ(File("a.stl", "rubbish").message(), "a.stl: is not an STL file: neither text nor binary");
}

TEST(ReadPly, KeepsPolygonsAndSharing) {
  const File file("a.ply",
                  ply_header(6, 2) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n-1 .5 0\n1 0 0\n4 0 1 2 3\n3 0 3 4\n");
  const PolygonMesh mesh = read_mesh(file.path());
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.positions[4], Vec3f(-1, 0.5f, 0));
  EXPECT_EQ(mesh.face_sizes, (std::vector<Index>{4, 3}));
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 3, 0, 3, 4}));
}

TEST(ReadPly, RejectsWhatIsWrong) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(ply_message(ply_header(3, 1) + vertices + "3 0 1 3\n"),
            "a.ply:face 1: names a vertex that is not among the 3");
  EXPECT_EQ(ply_message(ply_header(3, 1) + vertices + "3 0 1 -1\n"), "a.ply:face 1: names vertex -1");
  EXPECT_EQ(ply_message(ply_header(3, 2) + vertices + "3 0 1 2\n2 0 1\n"),
            "a.ply:face 2: a face of 2 corners");
  EXPECT_EQ(ply_message(ply_header(3, 2) + vertices + "3 0 1 2\n-1 0 1\n"),
            "a.ply:face 2: has a list of -1 entries");
  EXPECT_EQ(ply_message(ply_header(3, 1) + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
            "a.ply:vertex 2: a coordinate is not finite");
  EXPECT_EQ(ply_message(ply_header(3, 1) + "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"),
            "a.ply:vertex 2: 'x' is not a number");
  EXPECT_EQ(ply_message(ply_header(3, 1) + "0 0 0\n1 0\n"), "a.ply:vertex 2: the file is cut off");
  EXPECT_EQ(ply_message(ply_header(3, 0) + vertices), "a.ply: has no face");
  EXPECT_EQ(ply_message(ply_header(2000000000, 1)), "a.ply: is too short for 2000000000 vertex elements");
}

TEST(ReadPly, RejectsBrokenHeaders) {
  EXPECT_EQ(ply_message("plx\n"), "a.ply:1: is not a PLY file: it does not begin with 'ply'");
  EXPECT_EQ(ply_message("ply\nformat ascii 1.0\nelement vertex 3"), "a.ply:3: the header is cut off");
  EXPECT_EQ(ply_message("ply\nformat middle_endian 1.0\n"), "a.ply:2: 'middle_endian' is not a PLY format");
  EXPECT_EQ(ply_message("ply\nelement vertex many\n"), "a.ply:2: 'many' is not a number of elements");
  EXPECT_EQ(ply_message("ply\nelement vertex 3\nproperty list uchar quad x\n"),
            "a.ply:3: 'quad' is not a PLY type");
  EXPECT_EQ(ply_message("ply\nelement vertex 3\nend_header\n"), "a.ply:3: the header names no format");
  EXPECT_EQ(ply_message("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n"),
            "a.ply: its element 'vertex' has no property 'y'");
}

TEST(ReadPly, RejectsFilesCutOffAnywhere) {
  test::TemporaryFolder folder;
  const auto whole = folder.path() / "whole.ply";
  write_mesh(whole, test::torus(3, 3));
  const std::string bytes = read_file(whole);
  const std::size_t header = bytes.find("end_header") + 10;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string message = ply_message(bytes.substr(0, size));
    ASSERT_NE(message, "no error") << "cut at " << size;
    ASSERT_TRUE(size <= header || message.ends_with("is cut off")) << message << " cut at " << size;
  }
}

TEST(ReadPly, ReadsDataThatBeginsWithALineEnd) {
  test::TemporaryFolder folder;
  TriangleMesh mesh = test::torus(5, 4);
  mesh.positions[0].x() = std::bit_cast<float>(0x3f800d0au);
  write_mesh(folder.path() / "a.ply", mesh);
  EXPECT_EQ(read_mesh(folder.path() / "a.ply").positions, mesh.positions);
}

TEST(ReadPly, ReadsEveryTypeInBothByteOrdersAndSkipsTheRest) {
  const std::string names[] = {"format",
                               "element note 1",
                               "property uchar a",
                               "element vertex 3",
                               "property short x",
                               "property double y",
                               "property list uchar int skipped",
                               "property float z",
                               "element face 1",
                               "property list ushort uint vertex_index"};
  for (const bool big : {false, true}) {
    std::string header = "ply\r\ncomment\r\n";
    for (const std::string& line : names) {
      header += line;
      if (line == "format") header += big ? " binary_big_endian 1.0" : " binary_little_endian 1.0";
      header += "\r\n";
    }
    header += "end_header\r\n";
    std::string data;
    const auto put = [&](auto value) {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      if (big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof value);
      data.append(bytes, sizeof value);
    };
    put(std::uint8_t{7});
    for (const int i : {0, 1, 2}) {
      put(static_cast<std::int16_t>(-300 * i));
      put(0.25 * i);
      put(std::uint8_t{1});
      put(std::int32_t{99});
      put(static_cast<float>(i * i));
    }
    put(std::uint16_t{3});
    for (const std::uint32_t vertex : {2u, 1u, 0u}) put(vertex);
    const PolygonMesh mesh = read_mesh(File("a.ply", header + data).path());
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {-300, 0.25f, 1}, {-600, 0.5f, 4}}));
    EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{2, 1, 0}));
  }
}

TEST(ReadPly, ReadsTextureCoordinatesOfVerticesAndCorners) {
  const std::vector<Vec2f> expected = {{0, 0.25F}, {1, 0}, {0.5F, 1}};
  for (const std::string names : {"st", "uv"}) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float " +
        names.substr(0, 1) + "\nproperty double " + names.substr(1) +
        "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string data = "0 0 0 1 0\n1 0 0 .5 1\n0 1 0 0 .25\n3 2 0 1\n";
    EXPECT_EQ(read_mesh(File("a.ply", header + data).path()).corner_uv, expected);
  }
  std::string header = ply_header(3, 1);
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  header.insert(header.find("end_header"), "property list uchar float texcoord\nproperty int texnumber\n");
  const PolygonMesh corners =
      read_mesh(File("a.ply", header + vertices + "3 2 0 1 6 0 .25 1 0 .5 1 0\n").path());
  EXPECT_EQ(corners.corner_uv, expected);
  EXPECT_EQ(corners.not_used, "1 other property");
  header = ply_header(3, 1);
  header.insert(header.find("end_header"), "property list uchar float u\nproperty list uchar float v\n");
  EXPECT_EQ(read_mesh(File("a.ply", header + vertices + "3 2 0 1 3 0 1 .5 3 .25 0 1\n").path()).corner_uv,
            expected);
  EXPECT_EQ(read_mesh(File("a.ply", header + vertices + "3 2 0 1 0 0\n").path()).corner_uv.size(), 0u);
}

TEST(ReadPly, ReadsStrips) {
  std::string header = ply_header(5, 1);
  header.replace(header.find("element face"), 12, "element tristrips");
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const PolygonMesh mesh = read_mesh(File("a.ply", header + vertices + "9 0 1 2 3 -1 2 2 3 4\n").path());
  EXPECT_EQ(mesh.face_sizes, (std::vector<Index>(3, 3)));
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 1, 3, 2, 2, 4, 3}));
}

TEST(ReadPly, NamesRangeGrids) {
  std::string header = ply_header(1, 1);
  header.replace(header.find("element face"), 12, "element range_grid");
  const File file("a.ply", header + "0 0 0\n1 0\n");
  EXPECT_EQ(file.message(), "a.ply: holds a range grid, which is not read: join its points to faces first");
  EXPECT_FALSE(holds_points(file.path()));
}

TEST(ReadPly, ReadsHeadersWhoseLinesEndInCr) {
  for (const float x : {1.0F, std::bit_cast<float>(0x3f800d0aU), std::bit_cast<float>(0x3f8000ffU)}) {
    std::string bytes = ply_header(3, 1);
    bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
    std::ranges::replace(bytes, '\n', '\r');
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const float coordinate : {x, 0.0F, 0.0F, 1.0F, 2.0F, 3.0F, 0.0F, 1.0F, 0.0F}) put(coordinate);
    put(std::uint8_t{3});
    for (const int vertex : {0, 1, 2}) put(vertex);
    const PolygonMesh mesh = read_mesh(File("a.ply", bytes).path());
    EXPECT_EQ(mesh.positions[0].x(), x);
    EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
  }
}

TEST(ReadMesh, CountsFarPlacesFromANearOrigin) {
  std::string header = ply_header(3, 1);
  for (std::size_t at; (at = header.find("property float")) != std::string::npos;)
    header.replace(at + 9, 5, "double");
  const std::string vertices =
      "448262.01 5411932.25 117\n448262.51 5411932.25 117\n448262.01 5411932.75 117.125\n";
  for (const File& file : {File("a.ply", header + vertices + "3 0 1 2\n"),
                           File("a.obj",
                                "v 448262.01 5411932.25 117\nv 448262.51 5411932.25 117\n"
                                "v 448262.01 5411932.75 117.125\nf 1 2 3\n")}) {
    const PolygonMesh mesh = read_mesh(file.path());
    EXPECT_LT(mesh.positions[1].cwiseAbs().maxCoeff(), 2);
    EXPECT_LT((mesh.positions[1].cast<double>() + mesh.origin - Vec3d(448262.51, 5411932.25, 117)).norm(),
              1e-7);
  }
  EXPECT_EQ(read_mesh(File("a.obj", "v 15 0 0\nv 16 0 0\nv 15 1 0\nf 1 2 3\n").path()).origin,
            Vec3d(0, 0, 0));
}

TEST(ReadPly, ReadsTheDragon) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/dragon_vrip.ply");
  const PolygonMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.positions.size(), 437645u);
  EXPECT_EQ(mesh.face_sizes.size(), 871414u);
  EXPECT_EQ(mesh.face_vertices.size(), 3 * 871414u);
}

TEST(ReadStl, WeldsEqualPositions) {
  const File file(
      "a.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 -0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n");
  const PolygonMesh mesh = read_mesh(file.path());
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
}

TEST(ReadStl, ReadsASoup) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/nasty/soup.stl");
  const PolygonMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.positions.size(), 300u);
  EXPECT_EQ(mesh.face_sizes, std::vector<Index>(100, 3));
  const std::string bytes = read_file(path);
  EXPECT_NE(File("a.stl", bytes.substr(0, 3000)).message(), "no error");
}

TEST(ReadStl, RejectsCoordinatesThatAreNotFinite) {
  std::string bytes(80, ' ');
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(std::uint32_t{1});
  for (int i = 0; i < 12; ++i) put(i == 7 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i));
  put(std::uint16_t{0});
  EXPECT_EQ(File("a.stl", bytes).message(), "a.stl:vertex 2: a coordinate is not finite");
}

const std::string text_solid =
    "solid a b c\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a b c\n";

TEST(ReadStl, ReadsTextAsProgramsWriteIt) {
  const auto vertices = [](const std::string& content) {
    return read_mesh(File("a.stl", content).path()).face_vertices;
  };
  const std::vector<Index> expected = {0, 1, 2};
  std::string upper = text_solid, one_line = text_solid, infinite = text_solid, cr = text_solid;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  one_line.replace(one_line.find("outer loop\n"), 11, "outer loop ");
  infinite.replace(infinite.find("0 0 1"), 5, "-1.#IND nan 1.#QNAN");
  std::ranges::replace(cr, '\n', '\r');
  for (const std::string& text : {upper, one_line, infinite, cr, "\xef\xbb\xbf \n" + text_solid})
    EXPECT_EQ(vertices(text), expected) << text;
  EXPECT_EQ(vertices(text_solid + text_solid).size(), 6u);
}

TEST(ReadStl, NamesTheLineThatIsWrong) {
  const auto message = [](std::string from, const std::string& to) {
    std::string text = text_solid;
    text.replace(text.find(from), from.size(), to);
    return File("a.stl", text).message();
  };
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0"), "a.stl:5: a vertex needs three coordinates");
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0 1,5"), "a.stl:5: '1,5' is not a coordinate");
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0 nan"), "a.stl:5: the coordinate 'nan' is not finite");
  EXPECT_EQ(message("vertex 1 0 0", "corner 1 0 0"), "a.stl:5: 'corner' is not a word of an STL file");
  EXPECT_EQ(message("vertex 1 0 0\n", ""), "a.stl:6: a face of 2 corners");
  EXPECT_EQ(message("endsolid a b c\n", ""), "a.stl:8: the file is cut off: its solid does not end");
}

TEST(ReadStl, ReadsBinaryFilesThatAreLongerThanTheySay) {
  for (const std::string header : {"made by hand", "solid of a program that calls binary files so"}) {
    std::string bytes = header;
    bytes.resize(80);
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(std::uint32_t{1});
    for (const int number : {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) put(static_cast<float>(number));
    put(std::uint16_t{0});
    EXPECT_EQ(File("a.stl", bytes.substr(0, 100)).message(),
              "a.stl: is cut off: its 1 triangles need 134 bytes, it has 100");
    const PolygonMesh mesh = read_mesh(File("a.stl", bytes + "trailing").path());
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.not_used, "1 normal, 8 bytes behind the triangles");
  }
}

TEST(WritePly, ComesBackBitForBit) {
  test::TemporaryFolder folder;
  TriangleMesh mesh = test::torus(300, 150);
  mesh.positions[7] = {-0.0f, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  write_mesh(folder.path() / "a.ply", mesh);
  const TriangleMesh back = triangulate(read_mesh(folder.path() / "a.ply"));
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  EXPECT_EQ(std::memcmp(back.positions.data(), mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f)),
            0);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(WritePly, NamesTheFolderThatIsNotThere) {
  EXPECT_THROW(write_mesh("/nowhere/at/all.ply", test::torus(4, 4)), FileError);
}

std::string point_header(int points, const std::string& normals) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) +
         "\nproperty float x\nproperty float y\nproperty float z\n" + normals + "end_header\n";
}

TEST(PointFile, IsAPlyFileWithoutFaces) {
  const std::string normals = "property float nx\nproperty uchar red\nproperty float ny\nproperty float nz\n";
  const File file("a.ply", point_header(2, normals) + "0 1 2 0 255 0 1\n3 4 5 -2 0 0.5 0\n");
  EXPECT_TRUE(holds_points(file.path()));
  const PointSet points = read_points(file.path());
  EXPECT_EQ(points.positions, (std::vector<Vec3f>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(points.normals, (std::vector<Vec3f>{{0, 0, 1}, {-2, 0.5F, 0}}));
  EXPECT_FALSE(holds_points(File("a.ply", ply_header(3, 1)).path()));
  EXPECT_TRUE(holds_points(File("a.ply", ply_header(3, 0)).path()));
  EXPECT_FALSE(holds_points(File("a.obj", "v 0 0 0\n").path()));
  EXPECT_THROW(read_points(File("a.ply", point_header(1, "") + "0 0 0\n").path()), FileError);
  EXPECT_THROW(read_points(File("a.ply", point_header(2, normals) + "0 0 0 0 0 0 1\n").path()), FileError);
}

}  // namespace
}  // namespace burin
