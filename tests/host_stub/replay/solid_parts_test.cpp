// `burin replay` with a brush that makes solids.
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "host_stub/run_command.h"
#include "support/rods.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

using nlohmann::json;

/// A unit sphere and a tube along a part of its equator.
struct Laid {
  CommandFolder folder;
  TriangleMesh mesh = sphere(5, 0.2, 3);
  std::string mesh_path = folder.write("sphere.obj", obj_text(mesh));
  std::string stroke =
      folder.write("a.stroke", equator_stroke(-0.6, 0.6, 61, "\"brush\":\"org.burin.tube\",\"radius\":0.2"));

  json replayed(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", mesh_path, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return json::parse(burin_output(arguments));
  }
};

TEST(SolidParts, AreListedAndSavedBesideTheSurface) {
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply"), vdb = laid.folder.path("out.vdb");
  const json told = laid.replayed({"--save-mesh", saved, "--save-vdb", vdb, "--voxel", "0.01"});
  ASSERT_EQ(told["parts"].size(), 1u);
  const json& part = told["parts"][0];
  EXPECT_EQ(part["voxel"], 0.01);
  const double r = 0.4 * 0.2, length = 1.2;
  // The middle runs one radius above the sphere, where t and d are wider by 1 + h.
  const double wider = (1 + r) * (1 + r) + r * r / 4;
  const double volume = wider * (std::numbers::pi * r * r * length + 4 * std::numbers::pi / 3 * r * r * r);
  EXPECT_NEAR(part["volume"].get<double>(), volume, 0.01 * volume);
  const PolygonMesh mesh = read_mesh(saved);
  EXPECT_EQ(mesh.positions.size(), laid.mesh.positions.size() + part["vertices"].get<std::size_t>());
  const PolygonMesh before = read_mesh(laid.mesh_path);
  EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.end(), mesh.positions.begin()));
  EXPECT_EQ(read_file(vdb).substr(0, 4), " BDV");
}

TEST(SolidParts, AreLeftOutOnRequest) {
  const Laid laid;
  EXPECT_FALSE(laid.replayed({"--solid", "none"}).contains("parts"));
}

TEST(SolidParts, AreRefusedWhereTheyWouldTakeTooMuch) {
  const Laid laid;
  const std::string saved = laid.folder.path("out.ply");
  const ProcessResult refused =
      burin({"replay", laid.stroke, "--mesh", laid.mesh_path, "--voxel", "1e-5", "--save-mesh", saved});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("use larger voxels"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(saved));
}

TEST(SolidParts, RepeatWhatSaveVdbWrote) {
  const Laid laid;
  const std::string vdb = laid.folder.path("tube.vdb");
  laid.replayed({"--save-vdb", vdb, "--voxel", "0.02"});
  const json told = laid.replayed({"--brush", "org.burin.vdb-trail", "--param", "stamp=" + vdb});
  ASSERT_EQ(told["parts"].size(), 1u);
  EXPECT_GT(told["parts"][0]["volume"].get<double>(), 0);
}

TEST(SolidParts, AreNotMadeOfABrokenFile) {
  const Laid laid;
  const std::string vdb = laid.folder.path("tube.vdb"), saved = laid.folder.path("out.ply");
  laid.replayed({"--save-vdb", vdb, "--voxel", "0.02"});
  const std::string whole = read_file(vdb);
  for (const std::string& bytes :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("no volume")}) {
    const std::string broken = laid.folder.write("broken.vdb", bytes);
    const ProcessResult refused =
        burin({"replay", laid.stroke, "--mesh", laid.mesh_path, "--brush", "org.burin.vdb-trail", "--param",
               "stamp=" + broken, "--save-mesh", saved});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("broken.vdb: "), std::string::npos) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(saved));
  }
}

}  // namespace
}  // namespace burin::test
