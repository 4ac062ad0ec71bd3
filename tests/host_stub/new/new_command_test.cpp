#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../run_command.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

TEST(NewCommand, WritesAProjectThatSaysItsName) {
  const CommandFolder folder;
  const std::string text = burin_output({"new", folder.path("wavy_line"), "--features", "tile,paint"});
  EXPECT_EQ(text.find(folder.path("wavy_line") + ": a brush in C++. Next:\n"), 0u) << text;
  const std::string source = read_file(folder.path("wavy_line/wavy_line.cpp"));
  EXPECT_NE(source.find("class WavyLinePlugin : public Brush {"), std::string::npos) << source;
  EXPECT_NE(source.find(".id = \"org.example.wavy-line\""), std::string::npos);
  EXPECT_NE(source.find(".name = \"Wavy line\""), std::string::npos);
  EXPECT_NE(source.find("param_list(height, tile, colour)"), std::string::npos);
  EXPECT_NE(read_file(folder.path("wavy_line/CMakeLists.txt")).find("burin_test_brush(wavy_line)\n"),
            std::string::npos);
  for (const char* file : {"README.md", "CMakePresets.json", ".github/workflows/brush.yml"})
    EXPECT_EQ(read_file(folder.path("wavy_line/") + file).find("@NAME@"), std::string::npos);
}

TEST(NewCommand, KeepsSourcesShortWhateverTheyHave) {
  const CommandFolder folder;
  burin_output({"new", folder.path("one"), "--features", "tile,paint,volume"});
  burin_output({"new", folder.path("two"), "--c", "--features", "tile,paint"});
  burin_output({"new", folder.path("three"), "--c", "--features", "volume"});
  for (const char* source : {"one/one.cpp", "two/two.c", "three/three.c"})
    EXPECT_LE(std::ranges::count(read_file(folder.path(source)), '\n'), 60) << source;
}

TEST(NewCommand, WritesTheSampleInC) {
  const CommandFolder folder;
  burin_output({"new", folder.path("hello_brush_c"), "--c"});
  const fs::path sample = fs::path(BURIN_SAMPLES) / "hello_brush_c";
  for (const char* file : {"hello_brush_c.c", "CMakeLists.txt", "CMakePresets.json", "README.md"})
    EXPECT_EQ(read_file(folder.path("hello_brush_c/") + file), read_file(sample / file)) << file;
}

TEST(NewCommand, LeavesWhatExistsAsItIs) {
  const CommandFolder folder;
  fs::create_directory(folder.path("mine"));
  const ProcessResult result = burin({"new", folder.path("mine")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: " + folder.path("mine") + ": exists already\n");
  EXPECT_TRUE(fs::is_empty(folder.path("mine")));
}

TEST(NewCommand, TellsTheFolderThatThereIsNot) {
  const CommandFolder folder;
  const ProcessResult result = burin({"new", folder.path("nowhere/mine")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: " + folder.path("nowhere/mine") + ": there is no folder " +
                            folder.path("nowhere") + "\n");
}

TEST(NewCommand, RefusesNamesAndFeaturesThatAreNone) {
  const CommandFolder folder;
  const auto error = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"new", folder.path(name)});
    const ProcessResult result = burin(options);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_FALSE(fs::exists(folder.path(name)));
    return result.err;
  };
  EXPECT_EQ(error("My-Brush", {}),
            "burin: 'My-Brush': a name is of a-z, 0-9 and _ and begins with a letter\n");
  EXPECT_EQ(error("test", {}), "burin: 'test': CMake has a target of this name\n");
  EXPECT_TRUE(error("a" + std::string(40, 'b'), {}).ends_with(": a name has at most 40 characters\n"));
  EXPECT_EQ(error("one", {"--features", "tile,glow"}),
            "burin: --features: no 'glow'; there are: paint, tile, volume\n");
}

}  // namespace
}  // namespace burin::test
