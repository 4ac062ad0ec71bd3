#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "surface/mesh_text_file.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

using test::MeshFile;

std::string ply_message(const std::string& content) { return MeshFile("a.ply", content).message(); }

std::string ply_header(int vertices, int faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST(ReadPly, KeepsPolygonsAndSharing) {
  const MeshFile file("a.ply",
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
                               "property SHORT x",
                               "property Float64 y",
                               "property list uint8 int64 skipped",
                               "property float z",
                               "element face 1",
                               "property list uint64 uint vertex_index"};
  for (const bool big : {false, true}) {
    std::string header = "ply\r\ncomment\r\nCreated by Blender3D 247 - www.blender.org, source file: \r\n";
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
      put(std::int64_t{99});
      put(static_cast<float>(i * i));
    }
    put(std::uint64_t{3});
    for (const std::uint32_t vertex : {2u, 1u, 0u}) put(vertex);
    const PolygonMesh mesh = read_mesh(MeshFile("a.ply", header + data).path());
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
    EXPECT_EQ(read_mesh(MeshFile("a.ply", header + data).path()).corner_uv, expected);
  }
  std::string header = ply_header(3, 1);
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  header.insert(header.find("end_header"), "property list uchar float texcoord\nproperty int texnumber\n");
  const PolygonMesh corners =
      read_mesh(MeshFile("a.ply", header + vertices + "3 2 0 1 6 0 .25 1 0 .5 1 0\n").path());
  EXPECT_EQ(corners.corner_uv, expected);
  EXPECT_EQ(corners.not_used, "1 other property");
  header = ply_header(3, 1);
  header.insert(header.find("end_header"), "property list uchar float u\nproperty list uchar float v\n");
  EXPECT_EQ(read_mesh(MeshFile("a.ply", header + vertices + "3 2 0 1 3 0 1 .5 3 .25 0 1\n").path()).corner_uv,
            expected);
  EXPECT_EQ(read_mesh(MeshFile("a.ply", header + vertices + "3 2 0 1 0 0\n").path()).corner_uv.size(), 0u);
}

TEST(ReadPly, ReadsStrips) {
  std::string header = ply_header(5, 1);
  header.replace(header.find("element face"), 12, "element tristrips");
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const PolygonMesh mesh = read_mesh(MeshFile("a.ply", header + vertices + "9 0 1 2 3 -1 2 2 3 4\n").path());
  EXPECT_EQ(mesh.face_sizes, (std::vector<Index>(3, 3)));
  EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 1, 3, 2, 2, 4, 3}));
}

TEST(ReadPly, NamesRangeGrids) {
  std::string header = ply_header(1, 1);
  header.replace(header.find("element face"), 12, "element range_grid");
  const MeshFile file("a.ply", header + "0 0 0\n1 0\n");
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
    const PolygonMesh mesh = read_mesh(MeshFile("a.ply", bytes).path());
    EXPECT_EQ(mesh.positions[0].x(), x);
    EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
  }
}

TEST(ReadPly, ReadsTheDragon) {
  BURIN_SHARED_DATA_OR_SKIP(path, "meshes/dragon_vrip.ply");
  const PolygonMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.positions.size(), 437645u);
  EXPECT_EQ(mesh.face_sizes.size(), 871414u);
  EXPECT_EQ(mesh.face_vertices.size(), 3 * 871414u);
}

}  // namespace
}  // namespace burin
