#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "surface/mesh_text_file.h"

namespace burin {
namespace {

using test::MeshFile;

TEST(ReadStl, WeldsEqualPositions) {
  const MeshFile file(
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
  EXPECT_NE(MeshFile("a.stl", bytes.substr(0, 3000)).message(), "no error");
}

TEST(ReadStl, RejectsCoordinatesThatAreNotFinite) {
  std::string bytes(80, ' ');
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(std::uint32_t{1});
  for (int i = 0; i < 12; ++i) put(i == 7 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i));
  put(std::uint16_t{0});
  EXPECT_EQ(MeshFile("a.stl", bytes).message(), "a.stl:vertex 2: a coordinate is not finite");
}

const std::string text_solid =
    "solid a b c\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a b c\n";

TEST(ReadStl, ReadsTextInASingleLine) {
  std::string line = text_solid + "solid\n" + text_solid.substr(text_solid.find("facet"));
  line.insert(line.find("outer"), "color 1 0.5 0\n");
  std::ranges::replace(line, '\n', ' ');
  for (const std::string& text : {line, line + "\n", line + "solid empty endsolid empty"}) {
    const PolygonMesh mesh = read_mesh(MeshFile("a.stl", text).path());
    EXPECT_EQ(mesh.face_vertices, (std::vector<Index>{0, 1, 2, 3, 4, 5})) << "they stay apart";
    EXPECT_EQ(mesh.not_used, "1 colour, 2 normals");
  }
  std::string named = text_solid;
  named.replace(named.rfind("a b c"), 5, "of a solid facet");
  named.replace(named.find("a b c"), 5, "facet of a solid");
  EXPECT_EQ(read_mesh(MeshFile("a.stl", named).path()).face_vertices.size(), 3u) << "a name may be any words";
}

TEST(ReadStl, ReadsTextAsProgramsWriteIt) {
  const auto vertices = [](const std::string& content) {
    return read_mesh(MeshFile("a.stl", content).path()).face_vertices;
  };
  const std::vector<Index> expected = {0, 1, 2};
  std::string upper = text_solid, one_line = text_solid, infinite = text_solid, cr = text_solid,
              broken = text_solid;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  one_line.replace(one_line.find("outer loop\n"), 11, "outer loop ");
  infinite.replace(infinite.find("0 0 1"), 5, "-1.#IND nan 1.#QNAN");
  std::ranges::replace(cr, '\n', '\r');
  broken.replace(broken.find("normal 0 0 1"), 12, "normal\n0 0\n1");
  for (const std::string& text : {upper, one_line, infinite, cr, broken, "\xef\xbb\xbf \n" + text_solid})
    EXPECT_EQ(vertices(text), expected) << text;
  EXPECT_EQ(vertices(text_solid + text_solid).size(), 6u);
}

TEST(ReadStl, NamesTheLineThatIsWrong) {
  const auto message = [](std::string from, const std::string& to) {
    std::string text = text_solid;
    text.replace(text.find(from), from.size(), to);
    return MeshFile("a.stl", text).message();
  };
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0"), "a.stl:5: a vertex needs three coordinates");
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0 1,5"), "a.stl:5: '1,5' is not a coordinate");
  EXPECT_EQ(message("vertex 1 0 0", "vertex 1 0 nan"), "a.stl:5: the coordinate 'nan' is not finite");
  EXPECT_EQ(message("vertex 1 0 0", "corner 1 0 0"), "a.stl:5: 'corner' is not a word of an STL file");
  EXPECT_EQ(message("vertex 1 0 0\n", ""), "a.stl:6: a face of 2 corners");
  EXPECT_EQ(message("endsolid a b c\n", ""), "a.stl:8: the file is cut off: its solid does not end");
}

// Meshes are larger than other files: a text of five million triangles has more than 256 MiB.
TEST(ReadStl, ReadsFilesAsLargeAsScansAre) {
  std::string bytes(80, ' ');
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(std::uint32_t{1});
  for (const int number : {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) put(static_cast<float>(number));
  const MeshFile file("a.stl", bytes);
  std::filesystem::resize_file(file.path(), std::uintmax_t{300} << 20);
  EXPECT_EQ(read_mesh(file.path()).face_sizes.size(), 1U);
}

/// As programs leave it that write while they go.
TEST(ReadStl, CountsTheTrianglesWhereTheHeaderDoesNotTellThem) {
  for (const std::uint32_t announced : {0U, 0xFFFFFFFFU}) {
    std::string bytes(80, ' ');
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(announced);
    for (int triangle = 0; triangle < 2; ++triangle) {
      for (const int number : {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, triangle}) put(static_cast<float>(number));
      put(std::uint16_t{0});
    }
    EXPECT_EQ(read_mesh(MeshFile("a.stl", bytes).path()).face_sizes.size(), 2U);
    EXPECT_NE(MeshFile("a.stl", bytes + "x").message(), "no error") << "not a whole number of triangles";
  }
}

TEST(ReadStl, ReadsBinaryFilesThatAreLongerThanTheySay) {
  for (const std::string header : {"made by hand", "solid of a program that calls binary files so"}) {
    std::string bytes = header;
    bytes.resize(80);
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(std::uint32_t{1});
    for (const int number : {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) put(static_cast<float>(number));
    put(std::uint16_t{0});
    EXPECT_EQ(MeshFile("a.stl", bytes.substr(0, 100)).message(),
              "a.stl: is cut off: its 1 triangles need 134 bytes, it has 100");
    const PolygonMesh mesh = read_mesh(MeshFile("a.stl", bytes + "trailing").path());
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.not_used, "1 normal, 8 bytes behind the triangles");
  }
}

TEST(ReadStl, CountsTrianglesOfFewerThanThreePlaces) {
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex ",
                    end = "\nendloop\nendfacet\n";
  const auto not_used = [&](const std::string& facets) {
    const PolygonMesh mesh = read_mesh(MeshFile("a.stl", "solid a\n" + facets + "endsolid a\n").path());
    EXPECT_EQ(mesh.face_sizes.size(), 1u);
    return mesh.not_used;
  };
  const std::string whole = facet + "0 1 0" + end, thin = facet + "1 0 0" + end;
  EXPECT_EQ(not_used(whole), "1 normal");
  EXPECT_EQ(not_used(whole + thin), "2 normals, 1 triangle of fewer than three places");
  EXPECT_EQ(not_used(thin + whole + thin), "3 normals, 2 triangles of fewer than three places");
}

}  // namespace
}  // namespace burin
