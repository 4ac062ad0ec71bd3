#include <gtest/gtest.h>

#include <filesystem>

#include "host_stub/run_command.h"
#include "support/shapes.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

/// A sphere, a stroke that was recorded with the groove, and a folder without modules to name some in.
struct NamedModules {
  CommandFolder folder;
  std::string mesh = folder.write("sphere.obj", obj_text(sphere(4, 0, 1)));
  std::string stroke = folder.write(
      "a.stroke", equator_stroke(-0.6, 0.6, 21, "\"brush\":\"org.burin.groove\",\"radius\":0.3"));

  std::vector<std::string> replay(const std::string& brush) const {
    return {"replay", stroke, "--mesh", mesh, "--brush", brush};
  }
  std::string error(const std::vector<std::string>& command) const {
    const ProcessResult result = burin(command);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  }
};

const std::string several_brushes =
    fs::path(BURIN_TEST_PLUGINS).parent_path() / "test-brushes" / "probes.burin";

TEST(NamedBrush, OfAModuleIsDrawnByReplay) {
  const NamedModules modules;
  const fs::path bead = fs::path(BURIN_COMMAND).parent_path() / "brushes" / "bead.burin";
  EXPECT_EQ(burin_json(modules.replay(bead))["result_hash"],
            burin_json(modules.replay("org.burin.bead"))["result_hash"]);
  // It is nowhere on the search path.
  EXPECT_NE(burin_json(modules.replay(bad_plugin("good")))["result_hash"],
            burin_json(modules.replay("org.burin.groove"))["result_hash"]);
}

TEST(NamedBrush, MayBeAModuleWithTheIdOfAnInstalledOne) {
  const NamedModules modules;
  const fs::path stock = fs::path(BURIN_COMMAND).parent_path() / "brushes" / "bead.burin";
  fs::copy_file(stock, modules.folder.path("mine.burin"));
  const auto drawn = burin_json(modules.replay(modules.folder.path("mine.burin")));
  EXPECT_EQ(drawn["result_hash"], burin_json(modules.replay("org.burin.bead"))["result_hash"]);
}

TEST(NamedBrush, IsOneOfAModule) {
  const NamedModules modules;
  const std::string line = "burin: " + several_brushes +
                           ": has several brushes; name one: " + several_brushes +
                           ":org.burin.test.params, " + several_brushes + ":org.burin.test.start\n";
  EXPECT_EQ(modules.error(modules.replay(several_brushes)), line);
  EXPECT_EQ(modules.error({"try", several_brushes, "--png", modules.folder.path("a.png")}), line);
  const ProcessResult one = burin(modules.replay(several_brushes + ":org.burin.test.start"));
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(burin_output({"list", several_brushes + ":org.burin.test.start"}).find("org.burin.test.start"),
            0u);
  EXPECT_EQ(modules.error(modules.replay(several_brushes + ":org.none"))
                .find("burin: --brush: no brush 'org.none'"),
            0u);
}

TEST(NamedBrush, ThatIsNoFileIsSaidToBeNone) {
  const NamedModules modules;
  for (const std::string name : {"gone.burin", "./build/gone", "./gone.burin:org.none"})
    EXPECT_EQ(modules.error(modules.replay(name)),
              "burin: " + name.substr(0, name.find(':')) + ": there is no such file\n");
  EXPECT_EQ(modules.error(modules.replay(modules.mesh)).find("burin: " + modules.mesh + ": "), 0u);
  EXPECT_EQ(modules.error(modules.replay("org.none")).find("burin: --brush: "), 0u);
  const std::string folder = modules.folder.path("folder.burin");
  fs::create_directory(folder);
  EXPECT_EQ(modules.error(modules.replay(folder)), "burin: " + folder + ": is no file\n");
  EXPECT_EQ(modules.error(modules.replay("gone.burin:")),
            "burin: gone.burin:: the id of a brush is missing after the colon\n");
}

}  // namespace
}  // namespace burin::test
