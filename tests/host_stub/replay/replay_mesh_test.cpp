#include <burin/subdiv/sculpt_levels.h>
#include <burin/surface/mesh_file.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host_stub/picture_file.h"
#include "host_stub/run_command.h"

namespace burin::test {
namespace {

/// A ball of quads and a groove along its equator.
struct Ball {
  CommandFolder folder;
  std::string cage = folder.write("cube.obj", cube_obj());
  std::string stroke = folder.write(
      "a.stroke", equator_stroke(-0.6, 0.6, 61, "\"brush\":\"org.burin.groove\",\"radius\":0.3"));

  std::vector<std::string> command(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"replay", stroke, "--mesh", cage};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }

  std::vector<Vec3f> saved(std::vector<std::string> options) const {
    options.insert(options.end(), {"--save-mesh", folder.path("out.ply")});
    burin_output(command(options));
    return read_mesh(folder.path("out.ply")).positions;
  }
};

TEST(SculptLevelOption, DrawsOnOneLevelAndGivesTheFinest) {
  const Ball ball;
  const std::vector<Vec3f> drawn = ball.saved({"--subdivide", "4"});
  const std::vector<Vec3f> result = ball.saved({"--subdivide", "6", "--sculpt-level", "4"});
  // The session's result on level 4, brought up by the SDK.
  const PolygonMesh cage = read_mesh(ball.cage);
  SculptLevels levels(cage, natural_scheme(cage), 6);
  const std::vector<Vec3f> untouched(levels.positions(6).begin(), levels.positions(6).end());
  EXPECT_FALSE(std::ranges::equal(drawn, levels.positions(4)));
  levels.set_positions(4, drawn);
  EXPECT_TRUE(std::ranges::equal(result, levels.positions(6)));
  EXPECT_NE(result, untouched);
}

TEST(SculptLevelOption, TellsOfBothLevels) {
  const Ball ball;
  const nlohmann::json json = burin_json(ball.command({"--subdivide", "5", "--sculpt-level", "3"}));
  EXPECT_EQ(json["mesh"]["vertices"], 386);
  EXPECT_EQ(json["mesh"]["level"], 3);
  EXPECT_EQ(json["mesh"]["finest"], (nlohmann::json{{"level", 5}, {"vertices", 6146}, {"triangles", 12288}}));
  const std::string text = burin_output(ball.command({"--target-triangles", "12000", "--sculpt-level", "3"}));
  EXPECT_NE(text.find("386 vertices, 768 triangles on level 3; 6146 vertices, 12288 triangles on level 5"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(json["result_hash"].get<std::string>()), std::string::npos);
}

TEST(SculptLevelOption, OfTheFinestLevelChangesNothing) {
  const Ball ball;
  const auto hash = [&](const std::vector<std::string>& options) {
    return burin_json(ball.command(options))["result_hash"];
  };
  const nlohmann::json plain = hash({"--subdivide", "4"});
  EXPECT_EQ(hash({"--subdivide", "4", "--sculpt-level", "4"}), plain);
  EXPECT_NE(hash({"--subdivide", "4", "--sculpt-level", "3"}), plain);
  EXPECT_EQ(hash({"--sculpt-level", "0", "--radius", "2"}), hash({"--radius", "2", "--refine", "off"}));
}

TEST(SculptLevelOption, PicturesTheFinestLevel) {
  const Ball ball;
  const auto report = [&](const std::string& name, std::vector<std::string> options) {
    const std::string folder = ball.folder.path(name);
    options.insert(options.end(), {"--report", folder, "--width", "200", "--height", "150"});
    burin_output(ball.command(options));
    return folder;
  };
  // Both are drawn on level 3, and so seen by one camera.
  const std::string levels = report("levels", {"--subdivide", "5", "--sculpt-level", "3"});
  const std::string plain = report("plain", {"--subdivide", "3", "--refine", "off"});
  const auto picture = [](const std::string& folder, const std::string& name) {
    return read_png(folder + "/" + name + ".png").rgb;
  };
  EXPECT_EQ(picture(levels, "chart"), picture(plain, "chart"));
  EXPECT_NE(picture(levels, "before"), picture(plain, "before"));
  EXPECT_NE(picture(levels, "after"), picture(plain, "after"));
  EXPECT_NE(picture(levels, "after"), picture(levels, "before"));
}

}  // namespace
}  // namespace burin::test
