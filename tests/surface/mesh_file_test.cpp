#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <limits>

#include "surface/mesh_text_file.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

using test::MeshFile;

std::string ply_header(int vertices, int faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string obj_message(const std::string& content) { return MeshFile("a.obj", content).message(); }

std::string ply_message(const std::string& content) { return MeshFile("a.ply", content).message(); }

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
  EXPECT_EQ(MeshFile("a.xyz", "1 2 3").message(),
            "a.xyz: '.xyz' is not a mesh format; .obj, .ply, .stl, .off, .gltf and .glb are");
  EXPECT_NE(ply_message("ply\nrubbish\n"), "no error");
  EXPECT_EQ(MeshFile("a.stl", "rubbish").message(), "a.stl: is not an STL file: neither text nor binary");
}

TEST(ReadMesh, CountsFarPlacesFromANearOrigin) {
  std::string header = ply_header(3, 1);
  for (std::size_t at; (at = header.find("property float")) != std::string::npos;)
    header.replace(at + 9, 5, "double");
  const std::string vertices =
      "448262.01 5411932.25 117\n448262.51 5411932.25 117\n448262.01 5411932.75 117.125\n";
  for (const MeshFile& file : {MeshFile("a.ply", header + vertices + "3 0 1 2\n"),
                               MeshFile("a.obj",
                                        "v 448262.01 5411932.25 117\nv 448262.51 5411932.25 117\n"
                                        "v 448262.01 5411932.75 117.125\nf 1 2 3\n")}) {
    const PolygonMesh mesh = read_mesh(file.path());
    EXPECT_LT(mesh.positions[1].cwiseAbs().maxCoeff(), 2);
    EXPECT_LT((mesh.positions[1].cast<double>() + mesh.origin - Vec3d(448262.51, 5411932.25, 117)).norm(),
              1e-7);
  }
  EXPECT_EQ(read_mesh(MeshFile("a.obj", "v 15 0 0\nv 16 0 0\nv 15 1 0\nf 1 2 3\n").path()).origin,
            Vec3d(0, 0, 0));
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
  const MeshFile file("a.ply", point_header(2, normals) + "0 1 2 0 255 0 1\n3 4 5 -2 0 0.5 0\n");
  EXPECT_TRUE(holds_points(file.path()));
  const PointSet points = read_points(file.path());
  EXPECT_EQ(points.positions, (std::vector<Vec3f>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(points.normals, (std::vector<Vec3f>{{0, 0, 1}, {-2, 0.5F, 0}}));
  EXPECT_FALSE(holds_points(MeshFile("a.ply", ply_header(3, 1)).path()));
  EXPECT_TRUE(holds_points(MeshFile("a.ply", ply_header(3, 0)).path()));
  EXPECT_FALSE(holds_points(MeshFile("a.obj", "v 0 0 0\n").path()));
  EXPECT_THROW(read_points(MeshFile("a.ply", point_header(1, "") + "0 0 0\n").path()), FileError);
  EXPECT_THROW(read_points(MeshFile("a.ply", point_header(2, normals) + "0 0 0 0 0 0 1\n").path()),
               FileError);
}

}  // namespace
}  // namespace burin
