#include <burin/stamp/files/stamp_file.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/surface.h>
#include <burin/surface/triangulate.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_stub/run_command.h"

namespace burin::test {
namespace {

struct Map {
  int size = 0;
  std::vector<std::string> channels;
  std::vector<float> texels;

  explicit Map(const std::string& path) {
    StampFile file;
    const StampImage image = read_stamp(path, {}, &file);
    size = image.width;
    channels = file.channels;
    texels = image.texels;
  }

  /// Bilinear; beyond the outermost texels those hold.
  double at(const Vec2f& uv, std::size_t channel) const {
    const double x = std::clamp(double{uv.x()} * size - 0.5, 0.0, size - 1.001);
    const double y = std::clamp((1 - double{uv.y()}) * size - 0.5, 0.0, size - 1.001);
    double sum = 0;
    for (const double row : {std::floor(y), std::floor(y) + 1})
      for (const double column : {std::floor(x), std::floor(x) + 1}) {
        const auto texel = static_cast<std::size_t>(row * size + column);
        sum +=
            (1 - std::abs(x - column)) * (1 - std::abs(y - row)) * texels[texel * channels.size() + channel];
      }
    return sum;
  }
};

/// Spot with a groove along her flank.
class BakeOption : public testing::Test {
 protected:
  void SetUp() override {
    BURIN_SHARED_DATA_OR_SKIP(path, "meshes/spot_triangulated.obj");
    mesh_path = path.string();
    mesh = read_mesh(path);
    const Surface surface = make_surface(triangulate(mesh));
    normals.resize(mesh.positions.size());
    for (Index v = 0; v < surface.vertex_count(); ++v) normals[surface.source_vertex[v]] = surface.normals[v];
    std::string text =
        "{\"burin_stroke\":1,\"space\":\"object\"}\n"
        "{\"begin\":{\"brush\":\"org.burin.groove\",\"radius\":0.2,\"params\":{\"depth\":0.3,\"taper\":0}},"
        "\"fields\":[\"time\",\"x\",\"y\",\"z\"]}\n";
    for (int i = 0; i <= 40; ++i)
      text += fmt::format("[{},0.42,{},{}]\n", 0.01 * i, 0.1 - 0.002 * i, 0.5 - 0.015 * i);
    stroke = folder.write("flank.stroke", text + "{\"end\":true}\n");
  }

  /// The displacement of each vertex by the command.
  std::vector<Vec3f> moves(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"replay",      stroke,
                                          "--mesh",      mesh_path,
                                          "--save-mesh", folder.path("out.ply"),
                                          "--bake",      folder.path("map.exr")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    bake(arguments);
    std::vector<Vec3f> result = read_mesh(folder.path("out.ply")).positions;
    for (std::size_t v = 0; v < result.size(); ++v) result[v] -= mesh.positions[v];
    return result;
  }

  /// Runs the command, which warns: ten of her triangles lie a little beyond the image.
  void bake(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const ProcessResult result = burin(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("triangles reach beyond"), std::string::npos) << result.err;
    json = nlohmann::json::parse(result.out);
  }

  CommandFolder folder;
  std::string mesh_path, stroke;
  PolygonMesh mesh;
  std::vector<Vec3f> normals;  // [vertex]
  nlohmann::json json;
};

TEST_F(BakeOption, WritesTheHeightsOfAGroove) {
  double coarse = 0;
  for (const int size : {256, 1024}) {
    const std::vector<Vec3f> moved = moves({"--bake-size", std::to_string(size)});
    const Map map(folder.path("map.exr"));
    EXPECT_EQ(map.size, size);
    EXPECT_EQ(map.channels, std::vector<std::string>{"Y"});
    double deepest = 0, error = 0;
    int dented = 0;
    for (std::size_t corner = 0; corner < mesh.face_vertices.size(); ++corner) {
      const Index vertex = mesh.face_vertices[corner];
      const double height = moved[vertex].dot(normals[vertex]);
      error = std::max(error, std::abs(map.at(mesh.corner_uv[corner], 0) - height));
      deepest = std::min(deepest, height);
      dented += height < -0.01 ? 1 : 0;
    }
    std::cout << size << " texels: off by at most " << error << " of " << deepest << "\n";
    EXPECT_LT(deepest, -0.03);
    EXPECT_GT(dented, 200);
    if (size == 256) coarse = error;
    if (size == 1024) {
      EXPECT_LT(error, 0.06 * -deepest);
      EXPECT_LT(error, coarse / 2);
    }
  }
}

TEST_F(BakeOption, WritesVectors) {
  const std::vector<Vec3f> moved = moves({"--bake-vectors"});
  const Map map(folder.path("map.exr"));
  EXPECT_EQ(map.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(json["bake"], (nlohmann::json{{"file", folder.path("map.exr")},
                                          {"size", 1024},
                                          {"channels", {"R", "G", "B"}},
                                          {"overlapping_texels", 0},
                                          {"triangles_cut", 10},
                                          {"triangles_without_area", 0}}));
  for (std::size_t corner = 0; corner < mesh.face_vertices.size(); ++corner) {
    const Index vertex = mesh.face_vertices[corner];
    const Vec2f& uv = mesh.corner_uv[corner];
    const Vec3d value(map.at(uv, 0), map.at(uv, 1), map.at(uv, 2));
    EXPECT_NEAR(value.norm(), moved[vertex].norm(), 0.003);
    EXPECT_NEAR(value.z(), moved[vertex].dot(normals[vertex]), 0.003);
  }
}

TEST_F(BakeOption, WritesVectorsOfTheObject) {
  const std::vector<Vec3f> moved = moves({"--bake-vectors", "--bake-axes", "object", "--bake-middle", "0.5"});
  const Map map(folder.path("map.exr"));
  for (std::size_t corner = 0; corner < mesh.face_vertices.size(); ++corner) {
    const Vec2f& uv = mesh.corner_uv[corner];
    const Vec3d value(map.at(uv, 0), map.at(uv, 1), map.at(uv, 2));
    const Vec3d expected = moved[mesh.face_vertices[corner]].cast<double>() + Vec3d::Constant(0.5);
    EXPECT_LE((value - expected).norm(), 0.004);
  }
}

TEST_F(BakeOption, RefusesOtherAxes) {
  for (const char* axes : {"x,y", "x\x1b[2J", "world"}) {
    const ProcessResult result = burin({"replay", stroke, "--mesh", mesh_path, "--bake",
                                        folder.path("map.exr"), "--bake-vectors", "--bake-axes", axes});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err.find("burin: --bake-axes: takes x, y and z in any order"), 0u) << result.err;
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  }
}

// The finest level's displacement, of what was drawn on a coarser one.
TEST_F(BakeOption, MapsTheFinestLevel) {
  const std::vector<std::string> options = {"--subdivide", "1", "--bake-size", "512"};
  const auto deepest = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"replay",  stroke,   "--mesh",
                                          mesh_path, "--bake", folder.path("map.exr")};
    for (const auto* list : {&options, &more}) arguments.insert(arguments.end(), list->begin(), list->end());
    bake(arguments);
    return std::ranges::min(Map(folder.path("map.exr")).texels);
  };
  const float plain = deepest({}), drawn_on_the_cage = deepest({"--sculpt-level", "0"});
  EXPECT_LT(plain, -0.03F);
  EXPECT_NEAR(drawn_on_the_cage, plain, 0.2F * -plain);
  EXPECT_NE(drawn_on_the_cage, plain);
}

TEST_F(BakeOption, WarnsOfOverlaps) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/2 4/3\n";
  const ProcessResult result = burin({"replay", stroke, "--mesh", folder.write("twice.obj", text), "--bake",
                                      folder.path("map.exr"), "--bake-size", "64"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("map.exr: texture coordinates overlap at"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace burin::test
