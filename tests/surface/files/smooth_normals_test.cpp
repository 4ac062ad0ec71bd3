#include <burin/base/file.h>
#include <burin/surface/files/smooth_normals.h>
#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/shapes.h"
#include "support/shared_data.h"
#include "surface/test_meshes.h"

namespace burin {
namespace {

/// Every triangle with vertices of its own.
TriangleMesh apart(const TriangleMesh& mesh) {
  TriangleMesh split;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<Index>(split.positions.size());
    for (const Index vertex : triangle) split.positions.push_back(mesh.positions[vertex]);
    split.triangles.push_back({first, first + 1, first + 2});
  }
  return split;
}

TEST(SmoothNormals, PointOutOfASphereAcrossSeamsToo) {
  const TriangleMesh sphere = test::sphere(4, 0.2, 3);
  for (const TriangleMesh& mesh : {sphere, apart(sphere)}) {
    const std::vector<Vec3f> normals = smooth_normals(mesh);
    ASSERT_EQ(normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
      ASSERT_LT((normals[i] - mesh.positions[i].normalized()).norm(), 1e-5F) << i;
  }
}

TEST(SmoothNormals, AreInGlbFiles) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = test::torus(30, 20);
  write_mesh(folder.path() / "a.glb", mesh);
  EXPECT_EQ(read_mesh(folder.path() / "a.glb").not_used, "600 normals");
  const std::string bytes = read_file(folder.path() / "a.glb");
  const nlohmann::json json = nlohmann::json::parse(bytes.substr(20, bytes.find("BIN") - 24));
  const auto accessor = json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"].get<std::size_t>();
  const auto view = json["accessors"][accessor]["bufferView"].get<std::size_t>();
  const std::size_t at = bytes.find("BIN") + 4 + json["bufferViews"][view]["byteOffset"].get<std::size_t>();
  const std::vector<Vec3f> normals = smooth_normals(mesh);
  EXPECT_EQ(std::memcmp(bytes.data() + at, normals.data(), normals.size() * sizeof(Vec3f)), 0);
}

}  // namespace
}  // namespace burin
